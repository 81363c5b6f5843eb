// A ray caster the way a student of JavaScript writes it: a class for each thing, and objects that know what they do.
//
//   node cast.js SCENE [--mistake ID[,ID]] > picture.ppm
//
// The ray starts at the eye and goes through a point of a window before it, given by its lower left corner and its two sides.
// The sphere looks for the ray's point nearest to the center, the box asks each of its six faces, the triangle
// asks on which side of each edge a point of its plane is. The picture's lines are cast from the top.
// wrong("id") asks whether the mistake of that name was ordered on the command line.
"use strict";

const fs = require("fs");

const mistakes = new Set(process.argv[4] ? process.argv[4].split(",") : []);
const wrong = id => mistakes.has(id);

class Vector {
  constructor(x, y, z) { this.x = x; this.y = y; this.z = z; }
  static from([x, y, z]) { return new Vector(x, y, z); }
  plus(o) { return new Vector(this.x + o.x, this.y + o.y, this.z + o.z); }
  minus(o) { return new Vector(this.x - o.x, this.y - o.y, this.z - o.z); }
  times(s) { return new Vector(this.x * s, this.y * s, this.z * s); }
  dot(o) { return this.x * o.x + this.y * o.y + this.z * o.z; }
  cross(o) {
    const y = wrong("cross-y") ? this.x * o.z - this.z * o.x : this.z * o.x - this.x * o.z;
    return new Vector(this.y * o.z - this.z * o.y, y, this.x * o.y - this.y * o.x);
  }
  get squared() { return this.dot(this); }
  get length() { return wrong("len-nosqrt") ? this.squared : Math.sqrt(this.squared); }
  get normalized() { return this.times(1 / this.length); }
}

class Ray {
  constructor(origin, direction) { this.origin = origin; this.direction = direction; }
  at(t) { return this.origin.plus(this.direction.times(t)); }
}

// ---------- models: crossings(ray) is a list of t, the nearest first ----------

class Plane {
  constructor(point, normal) { this.point = point; this.normal = normal; }
  crossings(ray) {
    const slope = this.normal.dot(ray.direction);
    if (slope === 0) return [];
    if (wrong("plane-cull") && slope > 0) return [];
    return [this.point.minus(ray.origin).dot(this.normal) / slope];
  }
}

class Circle extends Plane {
  constructor(center, normal, radius) { super(center, normal); this.radius = radius; }
  crossings(ray) {
    const ts = super.crossings(ray);
    if (wrong("circ-inf")) return ts;
    return ts.filter(t => {
      const spoke = ray.at(t).minus(this.point);
      return wrong("circ-nosq") ? spoke.squared <= this.radius : spoke.length <= this.radius;
    });
  }
}

class Sphere {
  constructor(center, radius) { this.center = center; this.radius = radius; }
  crossings(ray) {
    const toCenter = wrong("oc-sign") ? ray.origin.minus(this.center) : this.center.minus(ray.origin);
    const middle = toCenter.dot(ray.direction);
    const gap = ray.direction.times(middle).minus(toCenter).squared; // from the center to the ray, squared
    const reach = (wrong("r-nosq") ? this.radius : this.radius ** 2) - gap;
    if (reach < 0 && !wrong("disc-nan")) return [];
    const half = Math.sqrt(reach);
    if (wrong("far-root")) return [middle + half];
    if (wrong("near-root-only")) return [middle - half];
    return [middle - half, middle + half];
  }
}

class Face {
  constructor(axis, value, low, high) { this.axis = axis; this.value = value; this.low = low; this.high = high; }
  crossing(ray) {
    if (ray.direction[this.axis] === 0) return null;
    const t = (this.value - ray.origin[this.axis]) / ray.direction[this.axis];
    const point = ray.at(t);
    for (const other of ["x", "y", "z"]) {
      if (other === this.axis) continue;
      if (other === "z" && wrong("slab-2axes")) continue;
      if (point[other] < this.low[other] || point[other] > this.high[other]) return null;
    }
    return t;
  }
}

class Box {
  constructor(low, high) {
    this.faces = [];
    for (const axis of wrong("slab-2axes") ? ["x", "y"] : ["x", "y", "z"])
      for (const corner of [low, high])
        this.faces.push(new Face(axis, corner[axis], low, high));
  }
  crossings(ray) {
    const ts = this.faces.map(face => face.crossing(ray)).filter(t => t !== null).sort((s, t) => s - t);
    if (wrong("slab-tmax")) return ts.slice(-1);
    if (wrong("slab-inside")) return ts.slice(0, 1);
    return ts;
  }
}

class Triangle {
  constructor(a, b, c) {
    this.corners = [a, b, c];
    this.normal = b.minus(a).cross(c.minus(a));
  }
  crossings(ray) {
    const slope = this.normal.dot(ray.direction);
    if (slope === 0) return [];
    if (wrong("tri-cull") && slope > 0) return [];
    const [a, b, c] = this.corners;
    const t = a.minus(ray.origin).dot(this.normal) / slope;
    const point = ray.at(t);
    const isLeftOf = (from, to) => to.minus(from).cross(point.minus(from)).dot(this.normal) >= 0;
    if (!wrong("tri-neg") && (!isLeftOf(a, b) || !isLeftOf(c, a))) return [];
    if (!wrong("tri-uv") && !isLeftOf(b, c)) return [];
    return [t];
  }
}

const makers = {
  plane: m => new Plane(Vector.from(m.point), Vector.from(m.normal)),
  sphere: m => new Sphere(Vector.from(m.center), m.radius),
  aabb: m => new Box(Vector.from(m.min), Vector.from(m.max)),
  circle: m => new Circle(Vector.from(m.center), Vector.from(m.normal), m.radius),
  triangle: m => new Triangle(Vector.from(m.a), Vector.from(m.b), Vector.from(m.c)),
};

// ---------- the camera ----------

class Camera {
  constructor({ position, target, up = [0, 0, 1], fovY = 45, width = 500, height = 500, zNear = 0.01, zFar = 100, bias = 1e-6,
    clip = "depth", sample = "corner" }) {
    Object.assign(this, { width, height, zNear, zFar, bias, clip });
    this.eye = Vector.from(position);
    const view = Vector.from(target).minus(this.eye);
    this.focus = view.length;
    this.forward = view.normalized;

    const turn = view.times(wrong("w-sign") ? 1 : -1);
    const w = wrong("w-unnorm") ? turn : turn.normalized;
    const upwards = Vector.from(up);
    const side = wrong("u-cross") ? w.cross(upwards) : upwards.cross(w);
    const u = wrong("u-unnorm") ? side : side.normalized;
    let v = wrong("v-cross") ? u.cross(w) : w.cross(u);
    if (wrong("v-up")) v = upwards;

    const angle = wrong("rad") ? fovY : fovY / 180 * Math.PI;
    let high = (wrong("no2") ? 1 : 2) * Math.tan(wrong("nohalf") ? angle : angle / 2);
    let wide = high * (width / height);
    if (wrong("aspect-inv")) wide = high * (height / width);
    if (wrong("aspect-none")) wide = high;
    if (wrong("fov-horiz")) { wide = high; high = wide / (width / height); }

    this.across = u.times(wrong("u-only") ? -wide : wide);
    this.upwards = v.times(high);
    const middle = w.times(-1);
    this.corner = wrong("no-center") ? middle : middle.minus(this.across.times(0.5)).minus(this.upwards.times(0.5));
    this.shift = (sample === "center") !== wrong("center") ? 0.5 : 0;
  }

  ray(x, y) {
    let s = (x + this.shift) / (wrong("wm1") ? this.width - 1 : this.width);
    const t = (this.height - 1 - y + this.shift) / (wrong("wm1") ? this.height - 1 : this.height);
    if (wrong("pix-int")) s = Math.floor(s); // in x alone: this student thought of it in y
    const through = this.corner.plus(this.across.times(s)).plus(this.upwards.times(t));
    return new Ray(this.eye, wrong("dir-unnorm-a1") ? through : through.normalized);
  }

  clips(ray, t) {
    const depth = ray.direction.times(t).dot(this.forward);
    const [right, other] = this.clip === "distance" ? [t, depth] : [depth, t];
    if (!wrong("no-znear") && !wrong("no-t0") && (wrong("znear-t") ? other : right) < this.zNear) return true;
    return !wrong("no-zfar") && (wrong("zfar-t") ? other : right) > this.zFar;
  }

  refuses(ray, t) {
    if (!wrong("no-t0") && (this.bias === 0 ? t < 0 : t <= this.bias)) return true;
    return !wrong("clip-after") && this.clips(ray, t);
  }
}

// ---------- the picture ----------

class World {
  constructor(scene) {
    const color = value => typeof value === "string" ? [1, 3, 5].map(i => parseInt(value.slice(i, i + 2), 16) / 255) : value;
    this.camera = new Camera(scene.camera);
    this.background = color(scene.background ?? [0, 0, 0]);
    this.models = scene.models.map(m => ({ shape: makers[m.type](m), color: color(m.color ?? [1, 1, 1]) }));
  }

  hit(ray) {
    let best = null;
    for (const model of this.models) {
      const t = model.shape.crossings(ray).find(t => !this.camera.refuses(ray, t));
      if (t === undefined) continue;
      if (best !== null && !wrong("last-hit") && (wrong("far-hit") ? t <= best.t : t >= best.t)) continue;
      best = { t, model };
    }
    return best !== null && wrong("clip-after") && this.camera.clips(ray, best.t) ? null : best;
  }

  color(ray) {
    const hit = this.hit(ray);
    if (hit === null) return this.background;
    let light = 1 - hit.t / ((wrong("att-no2") ? 1 : 2) * this.camera.focus);
    if (wrong("att-none")) light = 1;
    if (light < 0 && !wrong("noclamp")) light = 0;
    return hit.model.color.map(channel => channel * light);
  }

  draw() {
    const { width, height } = this.camera;
    const lines = [];
    for (let y = 0; y < height; y++) {
      const line = [];
      for (let x = 0; x < width; x++) line.push(this.color(this.camera.ray(x, y)));
      lines.push(line);
    }
    return lines;
  }
}

function toBytes(color) {
  const bytes = color.map(c => Math.trunc((wrong("noclamp") ? c : Math.min(Math.max(c, 0), 1)) * 255 + 0.5));
  return wrong("bgr") ? bytes.reverse() : bytes;
}

function write(lines) {
  if (wrong("rows")) lines.reverse();
  if (wrong("transpose")) lines = lines[0].map((_, x) => lines.map(line => line[x]));
  let size = [lines[0].length, lines.length];
  if (wrong("whswap")) size.reverse();
  const header = Buffer.from(`P6\n${size[0]} ${size[1]}\n255${wrong("crlf") ? "\r\n" : "\n"}`, "latin1");
  const pixels = Uint8Array.from(lines.flat().flatMap(toBytes)); // a number beyond 255 wraps round
  fs.writeSync(1, Buffer.concat([header, pixels]));
}

function readScene(path) {
  const text = fs.readFileSync(path, "utf8").replace(/^\uFEFF/, "");
  const bare = text.replace(/"(?:[^"\\]|\\.)*"|\/\/[^\n]*|\/\*[^]*?\*\//g, part => part.startsWith("\"") ? part : " ");
  return JSON.parse(bare.replace(/,(\s*[}\]])/g, "$1"));
}

write(new World(readScene(process.argv[2])).draw());
