/** What an address gives by name, after its #TAB&. */
export function valuesOf(hash: string): Map<string, string> {
  const parts = decodeURIComponent(hash).slice(1).split('&').slice(1);
  return new Map(parts.map((part) => [part.slice(0, part.indexOf('=')), part.slice(part.indexOf('=') + 1)]));
}
