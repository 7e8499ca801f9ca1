import { cross, dot, norm, subtract, unit } from './space.js';

// Edges sharper than this stay edges in the shading.
const CREASE = Math.cos(40 * Math.PI / 180);

const SURFACE_VERTEX = `#version 300 es
uniform mat4 camera, model;
in vec3 corner, normal;
out vec3 n;
void main() {
  n = mat3(model) * normal;
  gl_Position = camera * (model * vec4(corner, 1.0));
}`;

const SURFACE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 colour;
uniform vec3 light, up, toEye;
uniform float lit;
in vec3 n;
out vec4 pixel;
void main() {
  vec3 m = normalize(n);
  if (dot(m, toEye) < 0.0) m = -m;
  float day = 0.58 + 0.17 * dot(m, up);
  float sun = max(dot(m, light), 0.0);
  float shine = pow(max(dot(m, normalize(light + toEye)), 0.0), 40.0);
  vec3 shaded = colour.rgb * (day + 0.45 * sun) + 0.14 * shine;
  pixel = vec4(mix(colour.rgb, shaded, lit), colour.a);
}`;

const LINE_VERTEX = `#version 300 es
uniform mat4 camera;
uniform vec2 size;
uniform float width;
in vec3 from, to;
void main() {
  vec4 a = camera * vec4(from, 1.0), b = camera * vec4(to, 1.0);
  float inA = a.z + a.w, inB = b.z + b.w;
  if (inA < 0.0 && inB > 0.0) a = mix(a, b, inA / (inA - inB));
  if (inB < 0.0 && inA > 0.0) b = mix(b, a, inB / (inB - inA));
  vec2 way = (b.xy / b.w - a.xy / a.w) * size;
  float length2 = dot(way, way);
  vec2 along = length2 > 0.0 ? way * inversesqrt(length2) : vec2(1.0, 0.0);
  vec4 end = (gl_VertexID & 1) == 0 ? a : b;
  float side = gl_VertexID < 2 ? -1.0 : 1.0;
  float cap = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec2 offset = (vec2(-along.y, along.x) * side + along * cap * 0.5) * width / size;
  gl_Position = end + vec4(offset * end.w, 0.0, 0.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 colour;
out vec4 pixel;
void main() { pixel = colour; }`;

// Corners and normals of triangles that share no corner, smooth where faces meet in a flat angle.
export function shadedCorners(corners, triangles) {
  const count = triangles.length / 3;
  const faces = [];
  const around = Array.from({ length: corners.length / 3 }, () => []);
  const corner = i => [corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]];
  for (let face = 0; face < count; face++) {
    const [a, b, c] = [0, 1, 2].map(i => corner(triangles[3 * face + i]));
    faces.push(cross(subtract(b, a), subtract(c, a)));
    for (let i = 0; i < 3; i++) {
      around[triangles[3 * face + i]].push(face);
    }
  }
  const sizes = faces.map(norm);
  const out = new Float32Array(18 * count);
  for (let face = 0; face < count; face++) {
    for (let i = 0; i < 3; i++) {
      const index = triangles[3 * face + i];
      const sum = [0, 0, 0];
      for (const other of around[index]) {
        if (dot(faces[face], faces[other]) >= CREASE * sizes[face] * sizes[other]) {
          sum[0] += faces[other][0];
          sum[1] += faces[other][1];
          sum[2] += faces[other][2];
        }
      }
      out.set([...corner(index), ...unit(sum)], 6 * (3 * face + i));
    }
  }
  return out;
}

// Draws surfaces and lines by WebGL 2; undefined context means that there is none.
export class Canvas3D {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', { antialias: true, stencil: true, alpha: true });
    if (!this.gl) {
      return;
    }
    this.surface = this.program(SURFACE_VERTEX, SURFACE_FRAGMENT, ['corner', 'normal']);
    this.line = this.program(LINE_VERTEX, LINE_FRAGMENT, ['from', 'to']);
    this.gl.enable(this.gl.DEPTH_TEST);
    this.gl.blendFuncSeparate(
      this.gl.SRC_ALPHA, this.gl.ONE_MINUS_SRC_ALPHA, this.gl.ONE, this.gl.ONE_MINUS_SRC_ALPHA);
  }

  program(vertex, fragment, attributes) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    attributes.forEach((name, place) => gl.bindAttribLocation(program, place, name));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      throw new Error(gl.getProgramInfoLog(program) || 'the shaders do not link');
    }
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
      const name = gl.getActiveUniform(program, i).name;
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  mesh(corners, triangles) {
    const gl = this.gl;
    const data = shadedCorners(corners, triangles);
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 24, 0);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 24, 12);
    gl.bindVertexArray(null);
    return { array, count: triangles.length };
  }

  // Segments: six numbers each. A buffer that changes often may be given again.
  segments(numbers, old) {
    const gl = this.gl;
    const lines = old || { array: gl.createVertexArray(), buffer: gl.createBuffer() };
    gl.bindVertexArray(lines.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.DYNAMIC_DRAW);
    for (const place of [0, 1]) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, 12 * place);
      gl.vertexAttribDivisor(place, 1);
    }
    gl.bindVertexArray(null);
    lines.count = numbers.length / 6;
    return lines;
  }

  // Begins a picture; returns width over height.
  begin(background) {
    const gl = this.gl;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.ratio = ratio;
    gl.viewport(0, 0, width, height);
    gl.clearColor(...background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    return width / height;
  }

  look(camera, light, up, toEye) {
    const gl = this.gl;
    gl.useProgram(this.surface.program);
    gl.uniformMatrix4fv(this.surface.uniforms.camera, false, camera);
    gl.uniform3fv(this.surface.uniforms.light, light);
    gl.uniform3fv(this.surface.uniforms.up, up);
    gl.uniform3fv(this.surface.uniforms.toEye, toEye);
    gl.useProgram(this.line.program);
    gl.uniformMatrix4fv(this.line.uniforms.camera, false, camera);
    gl.uniform2f(this.line.uniforms.size, this.canvas.width, this.canvas.height);
  }

  drawMesh(mesh, model, colour, lit = 1) {
    const gl = this.gl;
    this.blend(colour[3] < 1);
    gl.useProgram(this.surface.program);
    gl.uniformMatrix4fv(this.surface.uniforms.model, false, model);
    gl.uniform4fv(this.surface.uniforms.colour, colour);
    gl.uniform1f(this.surface.uniforms.lit, lit);
    gl.bindVertexArray(mesh.array);
    gl.drawArrays(gl.TRIANGLES, 0, mesh.count);
  }

  drawLines(lines, colour, width, count = lines.count) {
    const gl = this.gl;
    if (count < 1) {
      return;
    }
    this.blend(colour[3] < 1);
    gl.useProgram(this.line.program);
    gl.uniform4fv(this.line.uniforms.colour, colour);
    gl.uniform1f(this.line.uniforms.width, width * this.ratio);
    gl.bindVertexArray(lines.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }

  blend(on) {
    const gl = this.gl;
    if (on) {
      gl.enable(gl.BLEND);
    } else {
      gl.disable(gl.BLEND);
    }
    gl.depthMask(!on);
  }

  // Draws flat shapes so that each pixel takes them once, however they overlap.
  once(draw) {
    const gl = this.gl;
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 0xff);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    draw();
    gl.disable(gl.STENCIL_TEST);
  }
}
