// A chart over time in a panel, and how it takes one to another time.

export interface TimeChart {
  svg: SVGSVGElement;
  /** Puts the line of the time shown there. */
  follow: (within_s: number) => void;
  /** The time at a place of the picture, as a share of its width. */
  timeAt: (share: number) => number;
}

/** A press or a drag on the chart goes to that time. */
export function seekable({ svg, timeAt }: TimeChart, seek: (within_s: number) => void): SVGSVGElement {
  const follow = (event: PointerEvent): void => {
    if (event.buttons === 0) return;
    const { left, width } = svg.getBoundingClientRect();
    seek(timeAt((event.clientX - left) / width));
  };
  svg.addEventListener('pointerdown', follow);
  svg.addEventListener('pointermove', follow);
  return svg;
}
