// Icons of the buttons, drawn as shapes.
const shapes = {
  play: 'M7 4v16l13-8z',
  pause: 'M6 4h4.5v16H6zM13.5 4H18v16h-4.5z',
  forward: 'M5 4v16l9-8zM16 4h3v16h-3z',
  back: 'M19 4v16l-9-8zM5 4h3v16H5z',
  next: 'M3 4v16l8-8zM11 4v16l8-8zM20 4h2v16h-2z',
  previous: 'M21 4v16l-8-8zM13 4v16l-8-8zM2 4h2v16H2z',
  restart: 'M12 5V1L6 6l6 5V7.5a5.5 5.5 0 1 1-5.3 7H4A8 8 0 1 0 12 5z',
  reverse: 'M9 5 3 10l6 5v-3.5h9V8.500H9zM15 12.500v3H6v3.500h9V22l6-4.500z',
} as const;

export type IconName = keyof typeof shapes;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={shapes[name]} />
    </svg>
  );
}
