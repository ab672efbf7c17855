// Unpacks the page's program, which the page holds compressed, and runs it.
import { bytesOfBase64 } from './data/base64';
import { inflate } from './data/inflate';

async function load(): Promise<void> {
  const code = await inflate(bytesOfBase64((document.getElementById('beespace-code')?.textContent ?? '').trim()));
  const script = document.createElement('script');
  script.text = new TextDecoder().decode(code);
  // It runs here, if it is the one that the page's policy names.
  document.head.append(script);
  script.remove();
  if (!document.documentElement.dataset.program) throw new Error('it does not run');
}

document.documentElement.dataset.code = 'there';
load().catch(() => (window as unknown as { beespaceDamaged?: () => void }).beespaceDamaged?.());
