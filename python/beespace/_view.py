"""Shows a page: in a notebook, or in a browser."""

from __future__ import annotations

import secrets
import sys
import threading
import webbrowser
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from beespace._errors import BeespaceError

# For how long a browser may take to begin, in seconds.
_patience = 60.0


def is_notebook() -> bool:
    """Whether what is displayed is shown by a kernel's front end."""
    ipython: Any = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    return getattr(shell, "kernel", None) is not None


def show_in_notebook(page: Any) -> None:
    from IPython.display import display  # pyright: ignore

    display(page)


def show_in_browser(page: str) -> None:
    """Opens a page that is fetched from this process, as there are browsers that may not read files
    of other programs. It is there as long as the process, for whom knows its address."""
    path = f"/{secrets.token_urlsafe(24)}.html"
    content = page.encode()
    fetched = threading.Event()

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            found = secrets.compare_digest(self.path.encode(), path.encode())
            self.send_response(200 if found else 404)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.send_header("Content-Length", str(len(content) if found else 0))
            self.send_header("Cache-Control", "no-store")
            self.end_headers()
            if found:
                self.wfile.write(content)
                fetched.set()

        def log_message(self, format: str, *args: Any) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, name="beespace.view", daemon=True).start()
    url = f"http://127.0.0.1:{server.server_port}{path}"
    if not webbrowser.open(url) or not fetched.wait(_patience):
        server.shutdown()
        server.server_close()
        raise BeespaceError(
            "no browser is there that fetches the page: write it with `save`, and open that file",
            "cannot_open",
        )
