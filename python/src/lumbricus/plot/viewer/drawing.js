// The recording, as frames.py writes it, and how a time of it is drawn with WebGL 2.

class Recording {
  constructor(words, numbers) {
    Object.assign(this, words);
    this.numbers = numbers;
    this.at = 0;
    const take = (Kind, n) => {
      // A copy: numbers of 32 bits begin at any byte.
      const bytes = numbers.slice(this.at, this.at += n * Kind.BYTES_PER_ELEMENT);
      return new Kind(bytes.buffer);
    };
    const takePlaces = (n, before) => {
      const low = take(Uint8Array, 3 * n), high = take(Uint8Array, 3 * n);
      const places = new Uint16Array(3 * n);
      for (let i = 0; i < 3 * n; i++)
        places[i] = low[i] + 256 * high[i] + (before ? before[i] : 0);
      return places;
    };
    for (const mesh of this.meshes) {
      mesh.index = take(Uint32Array, 3 * mesh.triangles);
      mesh.lineIndex = take(Uint32Array, 2 * mesh.lines);
      mesh.liquid = take(Uint8Array, mesh.skin);
    }
    for (const obstacle of this.obstacles) {
      obstacle.index = take(Uint32Array, 2 * obstacle.lines);
      obstacle.places = takePlaces(obstacle.points, null);
    }
    let before = null;
    for (const frame of this.frames) {
      const mesh = this.meshes[frame.mesh];
      frame.places = takePlaces(mesh.vertices, before && before.mesh === frame.mesh
        ? before.places : null);
      frame.colours = this.colourings.map(() => take(Uint8Array, mesh.skin));
      before = frame;
    }
  }

  // Coordinates at some places, x, y and z of one vertex after the other.
  points(places) {
    const n = places.length / 3, found = new Float32Array(3 * n);
    for (let d = 0; d < 3; d++)
      for (let i = 0; i < n; i++)
        found[3 * i + d] = this.low[d] - this.centre[d]
          + places[d * n + i] / 65535 * this.size[d];
    return found;
  }
}

const VERTEX = `#version 300 es
in vec3 place; in vec3 normal; in float colour; in float liquid;
uniform mat3 view; uniform vec3 scale; uniform vec2 shift; uniform float nearer;
uniform float scales;
out vec3 n; out vec2 where;
void main() {
  vec3 x = view * place * scale;
  gl_Position = vec4(x.xy + shift, -x.z - nearer, 1.0);
  n = view * normal;
  where = vec2((colour * 255.0 + 0.5) / 256.0,
               scales > 1.5 ? 0.25 + 0.5 * liquid : 0.25);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 n; in vec2 where;
uniform sampler2D colours; uniform vec4 plain;
out vec4 result;
void main() {
  if (plain.a > 0.0) { result = plain; return; }
  vec3 m = normalize(n) * (gl_FrontFacing ? 1.0 : -1.0);
  float light = 0.5 + 0.5 * max(dot(m, normalize(vec3(-0.3, 0.5, 0.8))), 0.0)
    + 0.25 * max(dot(m, normalize(vec3(0.7, -0.3, 0.6))), 0.0);
  result = vec4(texture(colours, where).rgb * min(light, 1.0), 1.0);
}`;

function plainColour(text) {
  return [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255).concat([1]);
}

const NOTHING = {index: new Uint32Array(0), places: new Uint16Array(0)};

class Painter {
  constructor(canvas, recording) {
    this.recording = recording;
    this.canvas = canvas;
    const gl = this.gl = canvas.getContext("webgl2", {antialias: true});
    if (!gl) throw new Error("This browser has no WebGL 2, which the scene needs.");
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX],
                                [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error("The scene cannot be drawn: " + gl.getProgramInfoLog(program));
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(1, 1, 1, 1);
    this.uniform = name => gl.getUniformLocation(program, name);
    this.buffers = {};
    for (const [name, size, kind, whole] of [
      ["place", 3, gl.FLOAT, false], ["normal", 4, gl.BYTE, true],
      ["colour", 1, gl.UNSIGNED_BYTE, true], ["liquid", 1, gl.UNSIGNED_BYTE, false]]) {
      this.buffers[name] = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
      const index = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, size, kind, whole, 0, 0);
    }
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.NEAREST],
                                 [gl.TEXTURE_MAG_FILTER, gl.NEAREST],
                                 [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
                                 [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]])
      gl.texParameteri(gl.TEXTURE_2D, name, value);
    this.elements = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.elements);
  }

  fill(name, values) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffers[name]);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, values, this.gl.DYNAMIC_DRAW);
  }

  // Take a time and a choice of colours.
  load(number, choice) {
    const gl = this.gl, recording = this.recording;
    const frame = recording.frames[number], mesh = recording.meshes[frame.mesh];
    const obstacle = recording.obstacles[frame.obstacle] || NOTHING;
    const n = mesh.vertices + obstacle.places.length / 3;
    // As long as all vertices, with zeros at the end.
    const padded = (Kind, size, ...parts) => {
      const all = new Kind(size);
      let at = 0;
      for (const part of parts) { all.set(part, at); at += part.length; }
      return all;
    };
    if (this.mesh !== mesh || this.obstacle !== obstacle) {
      [this.mesh, this.obstacle] = [mesh, obstacle];
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, padded(
        Uint32Array, 3 * mesh.triangles + 2 * mesh.lines + obstacle.index.length,
        mesh.index, mesh.lineIndex, obstacle.index.map(i => i + mesh.vertices)),
        gl.STATIC_DRAW);
      this.fill("liquid", padded(Uint8Array, n, mesh.liquid));
    }
    const points = recording.points(frame.places);
    this.fill("place", padded(Float32Array, 3 * n, points,
                              recording.points(obstacle.places)));
    this.fill("normal", padded(Int8Array, 4 * n,
                               normals(points, mesh.index, mesh.vertices)));
    this.fill("colour", padded(Uint8Array, n, frame.colours[choice]));
    const scales = recording.colourings[choice].scales;
    const dots = new Uint8Array(4 * 256 * 2).fill(255);
    for (let row = 0; row < 2; row++) {
      const text = scales[Math.min(row, scales.length - 1)].colours;
      for (let i = 0; i < 256; i++)
        for (let d = 0; d < 3; d++)
          dots[4 * (256 * row + i) + d] =
            parseInt(text.substr(6 * i + 2 * d, 2), 16);
    }
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 2, 0, gl.RGBA, gl.UNSIGNED_BYTE,
                  dots);
    gl.uniform1f(this.uniform("scales"), scales.length);
  }

  // Units of length that half of the canvas has, to the right and up.
  halfWindow(zoom) {
    const [width, height] = this.recording.window;
    const ratio = this.canvas.width / this.canvas.height;
    const half = Math.max(width / 2, height / 2 * ratio) / zoom;
    return [half, half / ratio];
  }

  draw(view, zoom, shift) {
    const gl = this.gl, recording = this.recording, mesh = this.mesh;
    const dots = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(this.canvas.clientWidth * dots);
    this.canvas.height = Math.round(this.canvas.clientHeight * dots);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const [x, y] = this.halfWindow(zoom);
    const depth = 2 * Math.hypot(...recording.size);
    gl.uniformMatrix3fv(this.uniform("view"), false, [0, 1, 2].flatMap(
      column => view.map(row => row[column])));
    gl.uniform3f(this.uniform("scale"), 1 / x, 1 / y, 1 / depth);
    gl.uniform2f(this.uniform("shift"), shift[0] / x, shift[1] / y);
    const part = (mode, begin, n, colour, nearer) => {
      gl.uniform4fv(this.uniform("plain"), colour);
      gl.uniform1f(this.uniform("nearer"), nearer);
      if (n > 0) gl.drawElements(mode, n, gl.UNSIGNED_INT, 4 * begin);
    };
    const [skin, lines] = [mesh.index.length, mesh.lineIndex.length];
    part(gl.TRIANGLES, 0, skin, [0, 0, 0, 0], 0);
    part(gl.LINES, skin, lines, plainColour(recording.line), 4e-4);
    part(gl.LINES, skin + lines, this.obstacle.index.length,
         plainColour(recording.obstacle), 0);
  }
}
