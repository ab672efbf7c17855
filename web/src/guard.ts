// Runs before all others: a page that was cut off or changed on its way says so, whatever of it is left.
// Nothing else of the page may be needed here.

let told = false;

function damaged(): void {
  if (told) return;
  told = true;
  document.documentElement.dataset.beespace = 'failed';
  const said = document.createElement('p');
  said.className = 'message';
  said.setAttribute('role', 'alert');
  said.textContent =
    'This page is damaged: a part of its program is missing or was changed on its way. Copy it again, or make it anew with `beespace report`.';
  document.getElementById('progress')?.remove();
  document.getElementById('stuck')?.remove();
  (document.getElementById('page') ?? document.body).prepend(said);
}

// The browser runs and applies only what the page's policy names, byte by byte.
addEventListener('DOMContentLoaded', () => {
  const root = document.documentElement;
  const styled = getComputedStyle(root).getPropertyValue('--ground') !== '';
  if (!root.dataset.code || !styled) damaged();
});
Object.assign(window, { beespaceDamaged: damaged });
