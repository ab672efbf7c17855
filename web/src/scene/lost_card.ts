// A graphics card that is lost, asleep or taken away comes back, mostly.
import { element } from '../text/element';

export function surviveLoss(canvas: HTMLCanvasElement, holder: HTMLElement, back: () => void): void {
  const word = element('p', { class: 'lost', role: 'status' }, 'The graphics card is gone for a moment …');
  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();
    holder.append(word);
  });
  canvas.addEventListener('webglcontextrestored', () => {
    word.remove();
    back();
  });
}
