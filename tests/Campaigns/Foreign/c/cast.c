/* A ray caster the way a student of C writes it: structs, loops, and nothing else.
 *
 *   cast SCENE [--mistake ID[,ID]] > picture.ppm
 *
 * The sphere is the quadratic formula, the box the slabs in a loop, the triangle Moeller and Trumbore's;
 * the rows are cast from the bottom.
 * wrong("id") asks whether the mistake of that name was ordered on the command line. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_MODELS 64
#define PI 3.14159265358979323846

static char mistakes[200] = ",";

static int wrong(const char *id)
{
    char wanted[40];
    snprintf(wanted, sizeof wanted, ",%s,", id);
    return strstr(mistakes, wanted) != NULL;
}

/* ---------- vectors ---------- */

typedef struct { double x, y, z; } Vec;

static Vec vec(double x, double y, double z) { Vec v = { x, y, z }; return v; }
static Vec add(Vec a, Vec b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static Vec sub(Vec a, Vec b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static Vec scale(double s, Vec a) { return vec(s * a.x, s * a.y, s * a.z); }
static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static Vec cross(Vec a, Vec b)
{
    Vec c;
    c.x = a.y * b.z - a.z * b.y;
    c.y = a.z * b.x - a.x * b.z;
    if (wrong("cross-y")) c.y = a.x * b.z - a.z * b.x;
    c.z = a.x * b.y - a.y * b.x;
    return c;
}

static double length(Vec a)
{
    if (wrong("len-nosqrt")) return dot(a, a);
    return sqrt(dot(a, a));
}

static Vec normalize(Vec a) { return scale(1 / length(a), a); }

/* ---------- the scene ---------- */

enum { PLANE, SPHERE, BOX, CIRCLE, TRIANGLE };

typedef struct {
    int type;
    Vec p, q, r;     /* point and normal; center; min and max; a, b, c */
    double radius;
    double color[3];
} Model;

static struct {
    Vec position, target, up;
    double fovY, zNear, zFar, bias;
    int width, height, byDistance, centers;
} camera;
static double background[3];
static Model models[MAX_MODELS];
static int modelCount;

static char *text; /* what is left of the scene file */

static void fail(const char *why) { fprintf(stderr, "cast: %s\n", why); exit(2); }

static char next(void)
{
    for (;;) {
        while (*text && (isspace((unsigned char)*text) || *text == ',' || *text == ':')) text++;
        if (text[0] == '/' && text[1] == '/') while (*text && *text != '\n') text++;
        else return *text;
    }
}

static int take(char c) { if (next() != c) return 0; text++; return 1; }

static void readString(char *s, int size)
{
    int n = 0;
    if (!take('"')) fail("a string is missing");
    while (*text && *text != '"') { if (n < size - 1) s[n++] = *text; text++; }
    s[n] = 0;
    text++;
}

static double readNumber(void) { next(); return strtod(text, &text); }

static Vec readVec(void)
{
    Vec v;
    if (!take('[')) fail("a vector is missing");
    v.x = readNumber(); v.y = readNumber(); v.z = readNumber();
    if (!take(']')) fail("a vector has no end");
    return v;
}

static void readColor(double *color)
{
    if (next() == '"') {
        char s[16];
        unsigned rgb;
        readString(s, sizeof s);
        if (sscanf(s, "#%x", &rgb) != 1) fail("a colour is not #rrggbb");
        color[0] = (rgb >> 16) / 255.0;
        color[1] = (rgb >> 8 & 255) / 255.0;
        color[2] = (rgb & 255) / 255.0;
    } else {
        Vec v = readVec();
        color[0] = v.x; color[1] = v.y; color[2] = v.z;
    }
}

static void readCamera(void)
{
    char key[40], word[20];
    camera.up = vec(0, 0, 1);
    camera.fovY = 45; camera.width = camera.height = 500;
    camera.zNear = 0.01; camera.zFar = 100; camera.bias = 1e-6;
    if (!take('{')) fail("camera is no object");
    while (!take('}')) {
        readString(key, sizeof key);
        if (!strcmp(key, "position")) camera.position = readVec();
        else if (!strcmp(key, "target")) camera.target = readVec();
        else if (!strcmp(key, "up")) camera.up = readVec();
        else if (!strcmp(key, "fovY")) camera.fovY = readNumber();
        else if (!strcmp(key, "width")) camera.width = (int)readNumber();
        else if (!strcmp(key, "height")) camera.height = (int)readNumber();
        else if (!strcmp(key, "zNear")) camera.zNear = readNumber();
        else if (!strcmp(key, "zFar")) camera.zFar = readNumber();
        else if (!strcmp(key, "bias")) camera.bias = readNumber();
        else if (!strcmp(key, "clip")) { readString(word, sizeof word); camera.byDistance = !strcmp(word, "distance"); }
        else if (!strcmp(key, "sample")) { readString(word, sizeof word); camera.centers = !strcmp(word, "center"); }
        else fail(key);
    }
}

static void readModel(Model *m)
{
    char key[40], word[40];
    m->color[0] = m->color[1] = m->color[2] = 1;
    if (!take('{')) fail("a model is no object");
    while (!take('}')) {
        readString(key, sizeof key);
        if (!strcmp(key, "type")) {
            readString(word, sizeof word);
            m->type = !strcmp(word, "plane") ? PLANE : !strcmp(word, "sphere") ? SPHERE : !strcmp(word, "aabb") ? BOX
                    : !strcmp(word, "circle") ? CIRCLE : !strcmp(word, "triangle") ? TRIANGLE : -1;
            if (m->type < 0) fail(word);
        }
        else if (!strcmp(key, "name")) readString(word, sizeof word);
        else if (!strcmp(key, "color")) readColor(m->color);
        else if (!strcmp(key, "radius")) m->radius = readNumber();
        else if (!strcmp(key, "point") || !strcmp(key, "center") || !strcmp(key, "min") || !strcmp(key, "a")) m->p = readVec();
        else if (!strcmp(key, "normal") || !strcmp(key, "max") || !strcmp(key, "b")) m->q = readVec();
        else if (!strcmp(key, "c")) m->r = readVec();
        else fail(key);
    }
}

static void readScene(const char *path)
{
    static char file[1 << 16];
    char key[40], word[200];
    FILE *f = fopen(path, "rb");
    if (!f) fail("cannot read the scene");
    file[fread(file, 1, sizeof file - 1, f)] = 0;
    fclose(f);
    text = file;
    if (!take('{')) fail("the scene is no object");
    while (!take('}')) {
        readString(key, sizeof key);
        if (!strcmp(key, "camera")) readCamera();
        else if (!strcmp(key, "background")) readColor(background);
        else if (!strcmp(key, "$schema")) readString(word, sizeof word);
        else if (!strcmp(key, "models")) {
            if (!take('[')) fail("models is no array");
            while (!take(']')) {
                if (modelCount == MAX_MODELS) fail("too many models");
                readModel(&models[modelCount++]);
            }
        }
        else fail(key);
    }
}

/* ---------- crossings: how many, and at which t, the nearest first ---------- */

static int crossPlane(Vec o, Vec d, Vec point, Vec normal, double *t)
{
    double dn = dot(d, normal);
    if (dn == 0) return 0;
    if (wrong("plane-cull") && dn > 0) return 0;
    *t = dot(sub(point, o), normal) / dn;
    return 1;
}

static int crossSphere(Vec o, Vec d, Vec center, double radius, double *t)
{
    Vec oc = wrong("oc-sign") ? sub(center, o) : sub(o, center);
    double a = dot(d, d);
    double b = 2 * dot(oc, d);
    double c = dot(oc, oc) - (wrong("r-nosq") ? radius : radius * radius);
    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0 && !wrong("disc-nan")) return 0;
    t[0] = (-b - sqrt(discriminant)) / (2 * a);
    t[1] = (-b + sqrt(discriminant)) / (2 * a);
    if (wrong("far-root")) { t[0] = t[1]; return 1; }
    if (wrong("near-root-only")) return 1;
    return 2;
}

static int crossBox(Vec o, Vec d, Vec min, Vec max, double *t)
{
    double origin[3] = { o.x, o.y, o.z }, direction[3] = { d.x, d.y, d.z };
    double low[3] = { min.x, min.y, min.z }, high[3] = { max.x, max.y, max.z };
    double tmin = -INFINITY, tmax = INFINITY;
    int axis, axes = wrong("slab-2axes") ? 2 : 3;
    for (axis = 0; axis < axes; axis++) {
        if (direction[axis] == 0) {
            if (origin[axis] < low[axis] || origin[axis] > high[axis]) return 0;
        } else {
            double t0 = (low[axis] - origin[axis]) / direction[axis];
            double t1 = (high[axis] - origin[axis]) / direction[axis];
            if (t0 > t1) { double swap = t0; t0 = t1; t1 = swap; }
            if (t0 > tmin) tmin = t0;
            if (t1 < tmax) tmax = t1;
        }
    }
    if (tmin > tmax) return 0;
    t[0] = tmin;
    t[1] = tmax;
    if (wrong("slab-tmax")) { t[0] = tmax; return 1; }
    if (wrong("slab-inside")) return 1;
    return 2;
}

static int crossCircle(Vec o, Vec d, Vec center, Vec normal, double radius, double *t)
{
    Vec fromCenter;
    if (!crossPlane(o, d, center, normal, t)) return 0;
    if (wrong("circ-inf")) return 1;
    fromCenter = sub(add(o, scale(*t, d)), center);
    if (wrong("circ-nosq")) return dot(fromCenter, fromCenter) <= radius;
    return length(fromCenter) <= radius;
}

static int crossTriangle(Vec o, Vec d, Vec a, Vec b, Vec c, double *t)
{
    Vec e1 = sub(b, a), e2 = sub(c, a), p = cross(d, e2), s, q;
    double det = dot(e1, p), u, v;
    if (det == 0) return 0;
    if (wrong("tri-cull") && det < 0) return 0;
    s = sub(o, a);
    u = dot(s, p) / det;
    q = cross(s, e1);
    v = dot(d, q) / det;
    if (!wrong("tri-neg") && (u < 0 || v < 0)) return 0;
    if (!wrong("tri-uv") && u + v > 1) return 0;
    *t = dot(e2, q) / det;
    return 1;
}

static int crossings(Vec o, Vec d, const Model *m, double *t)
{
    switch (m->type) {
    case PLANE: return crossPlane(o, d, m->p, m->q, t);
    case SPHERE: return crossSphere(o, d, m->p, m->radius, t);
    case BOX: return crossBox(o, d, m->p, m->q, t);
    case CIRCLE: return crossCircle(o, d, m->p, m->q, m->radius, t);
    default: return crossTriangle(o, d, m->p, m->q, m->r, t);
    }
}

/* ---------- rays ---------- */

static Vec W, U, V;
static double h, w;

static void aim(void)
{
    double angle = camera.fovY * PI / 180;
    double aspect = (double)camera.width / camera.height;
    W = sub(camera.position, camera.target);
    if (wrong("w-sign")) W = sub(camera.target, camera.position);
    if (!wrong("w-unnorm")) W = normalize(W);
    U = wrong("u-cross") ? cross(W, camera.up) : cross(camera.up, W);
    if (!wrong("u-unnorm")) U = normalize(U);
    V = wrong("v-cross") ? cross(U, W) : cross(W, U);
    if (wrong("v-up")) V = camera.up;
    if (wrong("u-only")) U = scale(-1, U);

    h = 2 * tan(angle / 2);
    if (wrong("rad")) h = 2 * tan(camera.fovY / 2);
    if (wrong("nohalf")) h = wrong("rad") ? 2 * tan(camera.fovY) : 2 * tan(angle);
    if (wrong("no2")) h = h / 2;
    w = h * aspect;
    if (wrong("aspect-none")) w = h;
    if (wrong("aspect-inv")) w = h / aspect;
    if (wrong("fov-horiz")) { w = h; h = w / aspect; }
}

static Vec direction(int row, int column)
{
    double shift = camera.centers != wrong("center") ? 0.5 : 0;
    int across = wrong("wm1") ? camera.width - 1 : camera.width, along = wrong("wm1") ? camera.height - 1 : camera.height;
    double uc = w * (column + shift) / across, ur = h * (row + shift) / along;
    Vec d;
    if (wrong("pix-int")) { uc = w * (column / camera.width); ur = h * (row / camera.height); }
    if (!wrong("no-center")) { uc -= w / 2; ur -= h / 2; }
    d = sub(add(scale(uc, U), scale(ur, V)), W);
    return wrong("dir-unnorm") ? d : normalize(d);
}

static int clipped(Vec d, double t)
{
    double depth = t * -dot(d, W), near, far;
    near = far = camera.byDistance ? t : depth;
    if (wrong("znear-t")) near = camera.byDistance ? depth : t;
    if (wrong("zfar-t")) far = camera.byDistance ? depth : t;
    if (!wrong("no-znear") && !wrong("no-t0") && near < camera.zNear) return 1;
    if (!wrong("no-zfar") && far > camera.zFar) return 1;
    return 0;
}

static int refused(Vec d, double t)
{
    if (!wrong("no-t0") && (camera.bias == 0 ? t < 0 : t <= camera.bias)) return 1;
    return !wrong("clip-after") && clipped(d, t);
}

static void shade(Vec d, double *color)
{
    double best = wrong("far-hit") ? -INFINITY : INFINITY, attenuation;
    const Model *hit = NULL;
    int i, k;
    for (i = 0; i < modelCount; i++) {
        double t[2];
        int n = crossings(camera.position, d, &models[i], t);
        for (k = 0; k < n; k++) {
            if (refused(d, t[k])) continue;
            if (wrong("far-hit") ? t[k] <= best : !wrong("last-hit") && t[k] >= best) break;
            best = t[k];
            hit = &models[i];
            break;
        }
    }
    if (hit != NULL && wrong("clip-after") && clipped(d, best)) hit = NULL;
    if (hit == NULL) { memcpy(color, background, sizeof background); return; }
    attenuation = 1 - best / (2 * length(sub(camera.target, camera.position)));
    if (wrong("att-no2")) attenuation = 1 - best / length(sub(camera.target, camera.position));
    if (wrong("att-none")) attenuation = 1;
    if (attenuation < 0 && !wrong("noclamp")) attenuation = 0;
    for (k = 0; k < 3; k++) color[k] = attenuation * hit->color[k];
}

static unsigned char toByte(double channel)
{
    if (!wrong("noclamp")) {
        if (channel < 0) channel = 0;
        if (channel > 1) channel = 1;
    }
    return (unsigned char)(int)(channel * 255 + 0.5);
}

int main(int argc, char **argv)
{
    int row, column, line, k, width, height;
    unsigned char *picture;
    if (argc != 2 && argc != 4) fail("usage: cast SCENE [--mistake ID[,ID]] > picture.ppm");
    if (argc == 4) snprintf(mistakes, sizeof mistakes, ",%s,", argv[3]);
    readScene(argv[1]);
    aim();
    width = camera.width;
    height = camera.height;
    picture = malloc((size_t)width * height * 3);
    for (row = 0; row < height; row++) {
        line = wrong("rows") ? row : height - 1 - row;
        for (column = 0; column < width; column++) {
            double color[3];
            size_t place = wrong("transpose") ? (size_t)column * height + line : (size_t)line * width + column;
            shade(direction(row, column), color);
            for (k = 0; k < 3; k++) picture[place * 3 + k] = toByte(color[wrong("bgr") ? 2 - k : k]);
        }
    }
    if (wrong("transpose") != wrong("whswap")) printf("P6\n%d %d\n255", height, width);
    else printf("P6\n%d %d\n255", width, height);
    printf(wrong("crlf") ? "\r\n" : "\n");
    fwrite(picture, 3, (size_t)width * height, stdout);
    free(picture);
    return 0;
}
