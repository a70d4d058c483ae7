// Draws many disks with WebGL2: a triangle around each, which the fragment shader rounds off. Disks come in a texture, not as
// instances: browsers that draw without a graphics card take each instance for a picture of its own.
import type { DiskPainter } from './drawing';
import { plain, ramp } from './shades';

/** Disks in a row of a texture. */
const row = 256;

const vertexShader = `#version 300 es
uniform highp sampler2D disks; // x, y, shade of each, in rows of ROW
uniform highp sampler2D radii;
uniform vec2 size;    // of the box
uniform float scale;  // pixels per length
out vec2 place;       // from the disk's centre, in pixels
flat out float reach; // its radius in pixels
flat out vec3 colour;
const vec3 plain = PLAIN;
const vec3 ramp[STOPS] = vec3[](RAMP);
vec3 colourOf(float shade) {
  if (shade < 0.0) return plain;
  float at = clamp(shade, 0.0, 0.9999) * float(STOPS - 1);
  int k = int(at);
  return mix(ramp[k], ramp[k + 1], at - float(k));
}
// Of the triangle around a circle of radius 1.
const vec2 corners[3] = vec2[](vec2(-1.7321, -1), vec2(1.7321, -1), vec2(0, 2));
void main() {
  int k = gl_VertexID / 3;
  vec2 corner = corners[gl_VertexID - 3 * k];
  ivec2 at = ivec2(k % ROW, k / ROW);
  vec3 disk = texelFetch(disks, at, 0).xyz;
  float radius = texelFetch(radii, at, 0).x * scale;
  reach = max(0.5, max(radius * 0.96, radius - 1.0)); // so that one sees them touch, and yet apart
  place = corner * (reach + 1.0);
  colour = colourOf(disk.z);
  gl_Position = vec4((disk.xy + place / scale) / size * 2.0 - 1.0, 0.0, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec2 place;
flat in float reach;
flat in vec3 colour;
out vec4 pixel;
void main() {
  float inside = clamp(reach + 0.5 - length(place), 0.0, 1.0);
  pixel = vec4(colour * inside, inside);
}`;

const vec3 = (colour: readonly number[]): string => `vec3(${colour.map((one) => (one / 255).toFixed(4)).join(', ')})`;

const withColours = (source: string): string =>
  source.replaceAll('STOPS', `${ramp.length}`).replaceAll('ROW', `${row}`).replace('PLAIN', vec3(plain)).replace('RAMP', ramp.map(vec3).join(', '));

function compiled(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, withColours(vertexShader)], [gl.FRAGMENT_SHADER, fragmentShader]] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  return program;
}

/** A texture of so many numbers for each disk, to be read one by one. */
function textureFor(gl: WebGL2RenderingContext, format: GLenum, count: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, row, Math.ceil(count / row));
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

/** Puts numbers into the texture that is bound: the full rows, and what is left. */
function fill(gl: WebGL2RenderingContext, format: GLenum, each: number, numbers: Float32Array): void {
  const count = numbers.length / each;
  const rows = Math.floor(count / row);
  const put = (from: number, width: number, height: number, part: Float32Array): void => {
    if (part.length > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, from, width, height, format, gl.FLOAT, part);
  };
  put(0, row, rows, numbers.subarray(0, each * row * rows));
  put(rows, count % row, 1, numbers.subarray(each * row * rows));
}

/** What the graphics card holds for one gas. */
interface Held {
  program: WebGLProgram;
  disks: WebGLTexture;
  radii: WebGLTexture;
  scale: WebGLUniformLocation;
}

export class WebglDisks implements DiskPainter {
  private held: Held | null;

  private constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly kinds: Float64Array,
    private readonly size: { width: number; height: number },
  ) {
    this.held = this.prepare();
    gl.canvas.addEventListener('webglcontextlost', this.lost);
    gl.canvas.addEventListener('webglcontextrestored', this.restored);
  }

  /** Nothing where the browser has no WebGL2. */
  static on(canvas: HTMLCanvasElement, kinds: Float64Array, size: { width: number; height: number }): WebglDisks | null {
    const gl = canvas.getContext('webgl2', { antialias: false, depth: false, powerPreference: 'low-power' });
    return gl && new WebglDisks(gl, kinds, size);
  }

  private readonly lost = (event: Event): void => {
    event.preventDefault();
    this.held = null;
  };
  private readonly restored = (): void => void (this.held = this.prepare());

  private prepare(): Held {
    const { gl, kinds, size } = this;
    const program = compiled(gl);
    gl.useProgram(program);
    const uniform = (name: string): WebGLUniformLocation => gl.getUniformLocation(program, name)!;
    gl.uniform1i(uniform('disks'), 0);
    gl.uniform1i(uniform('radii'), 1);
    gl.uniform2f(uniform('size'), size.width, size.height);
    const count = kinds.length / 2;
    gl.activeTexture(gl.TEXTURE1);
    const radii = textureFor(gl, gl.R32F, count);
    fill(gl, gl.RED, 1, Float32Array.from({ length: count }, (_, k) => kinds[2 * k]!));
    gl.activeTexture(gl.TEXTURE0);
    const disks = textureFor(gl, gl.RGB32F, count);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.clearColor(0, 0, 0, 0);
    return { program, disks, radii, scale: uniform('scale') };
  }

  paint(disks: Float32Array, scale: number): void {
    const { gl, held } = this;
    if (!held) return;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.uniform1f(held.scale, scale);
    fill(gl, gl.RGB, 3, disks);
    gl.drawArrays(gl.TRIANGLES, 0, disks.length);
  }

  /** The context stays with its canvas, for the next gas. */
  dispose(): void {
    const { gl, held } = this;
    gl.canvas.removeEventListener('webglcontextlost', this.lost);
    gl.canvas.removeEventListener('webglcontextrestored', this.restored);
    this.held = null;
    if (!held) return;
    gl.deleteProgram(held.program);
    gl.deleteTexture(held.disks);
    gl.deleteTexture(held.radii);
  }
}
