// The play area as a picture that stands by itself.
const properties = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'font-size', 'font-family', 'font-weight', 'font-style', 'display', 'visibility', 'stroke-linecap', 'paint-order'];

/** A copy of the SVG with its looks written into it. */
export function standaloneSvg(): string {
  const source = document.querySelector<SVGSVGElement>('#play-area')!;
  const copy = source.cloneNode(true) as SVGSVGElement;
  const originals = [source, ...source.querySelectorAll('*')];
  [copy, ...copy.querySelectorAll('*')].forEach((element, k) => {
    const style = getComputedStyle(originals[k]!);
    // As attributes: styles in the text would be against the page's own policy.
    for (const name of properties) element.setAttribute(name, style.getPropertyValue(name));
    for (const name of ['style', 'tabindex', 'role', 'class', 'aria-label', 'aria-roledescription']) element.removeAttribute(name);
  });
  copy.querySelectorAll('[data-tip]').forEach((handle) => handle.remove());
  const { width, height } = source.viewBox.baseVal;
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', `${width}`);
  copy.setAttribute('height', `${height}`);
  return new XMLSerializer().serializeToString(copy);
}

export async function pngOfSvg(svg: string): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = 2 * image.width;
  canvas.height = 2 * image.height;
  canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
  return pngOfCanvas(canvas);
}

export function pngOfCanvas(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png'));
}
