"use strict";
// Rotations as three rows: what is to the right, up, and towards the viewer.

// v turned by an angle about the unit vector a (Rodrigues).
function turned(v, a, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  const along = (1 - c) * (v[0] * a[0] + v[1] * a[1] + v[2] * a[2]);
  return [v[0] * c + (a[1] * v[2] - a[2] * v[1]) * s + a[0] * along,
          v[1] * c + (a[2] * v[0] - a[0] * v[2]) * s + a[1] * along,
          v[2] * c + (a[0] * v[1] - a[1] * v[0]) * s + a[2] * along];
}

function normalized(v) {
  const size = Math.hypot(...v) || 1;
  return v.map(x => x / size);
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]];
}

// The view after the body was dragged by angles to the right and up, orthogonal
// again after many times.
function dragged(view, right, up) {
  const [x, y] = view.map(row =>
    turned(turned(row, view[1], -right), view[0], up));
  const first = normalized(x);
  const third = normalized(cross(first, y));
  return [first, cross(third, first), third];
}

// Of every vertex the sum of the normals of its triangles, each as long as twice its
// area, as bytes.
function normals(points, triangles, nVertices) {
  const sums = new Float32Array(3 * nVertices);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1],
          uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1],
          vz = points[c + 2] - points[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const i of [a, b, c]) {
      sums[i] += x; sums[i + 1] += y; sums[i + 2] += z;
    }
  }
  const found = new Int8Array(4 * nVertices);
  for (let i = 0; i < nVertices; i++) {
    const size = Math.hypot(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]) || 1;
    for (let d = 0; d < 3; d++)
      found[4 * i + d] = Math.round(127 * sums[3 * i + d] / size);
  }
  return found;
}
