// Embree 3 in its fastest ways, on the rays of the benchmark. Built at run time:
//     g++ -O3 -march=native -ffast-math -std=c++17 embree_peer.cpp -lembree3 -pthread
//
//     embree_peer SCENE BUILD-THREADS          reads a scene of the benchmark and obeys commands on standard input:
//         size WIDTH HEIGHT                    -> ok
//         build ISA FLAGS SHAPES               -> milliseconds that the hierarchy takes; done by "run" when it is not there
//         run ISA FLAGS SHAPES CALL ANSWER THREADS   -> milliseconds of one picture: ray generation, tracing, writing the answer
//         dump ISA FLAGS SHAPES CALL FILE      -> ok; the file gets a float t and an int model for each pixel, top line first
//     embree_peer SCENE THREADS PLY WIDTH HEIGHT QUALITY     reads the scene's camera and a binary PLY, builds, traces bytes, ends
//         QUALITY: medium or low, which build faster and trace slower; the commands above build in high quality
//
// ISA: avx2, or best (the device's own choice). FLAGS: none, compact. SHAPES: user (user geometries) or native (Embree's own quads,
// spheres and discs). CALL: 8, 16 (coherent packets), 1m, nm8, nm16, np (streams of 256 rays). ANSWER: hits (t, model) or bytes.

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

using namespace std;

struct V { float x, y, z; };
static V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static V operator*(float s, V a) { return {s * a.x, s * a.y, s * a.z}; }

[[noreturn]] static void fail(const string& message) { cout << "error " << message << endl; exit(1); }

static double now() { return chrono::duration<double, milli>(chrono::steady_clock::now().time_since_epoch()).count(); }

// The processor time of this thread alone, which other work of the machine hardly changes.
static double threadTime() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec * 1e3 + time.tv_nsec / 1e6;
}

// ---------------------------------------------------------------------------------------------------------------- the scene

struct PlaneShape {
    V q, n;
    float cross(float ox, float oy, float oz, float dx, float dy, float dz, float, float) const {
        return ((q.x - ox) * n.x + (q.y - oy) * n.y + (q.z - oz) * n.z) / (dx * n.x + dy * n.y + dz * n.z);
    }
};
struct SphereShape {
    V c; float r;
    float cross(float ox, float oy, float oz, float dx, float dy, float dz, float tNear, float) const {
        float lx = c.x - ox, ly = c.y - oy, lz = c.z - oz;
        float t_ca = lx * dx + ly * dy + lz * dz;
        float px = lx - t_ca * dx, py = ly - t_ca * dy, pz = lz - t_ca * dz;
        float square = r * r - (px * px + py * py + pz * pz);
        float t_hc = sqrtf(max(square, 0.0f));
        float t = t_ca - t_hc >= tNear ? t_ca - t_hc : t_ca + t_hc;
        return square >= 0 ? t : -1.0f;
    }
};
struct BoxShape {
    V lo, hi;
    float cross(float ox, float oy, float oz, float dx, float dy, float dz, float tNear, float) const {
        float ix = 1 / dx, iy = 1 / dy, iz = 1 / dz;
        float x0 = (lo.x - ox) * ix, x1 = (hi.x - ox) * ix, y0 = (lo.y - oy) * iy, y1 = (hi.y - oy) * iy;
        float z0 = (lo.z - oz) * iz, z1 = (hi.z - oz) * iz;
        float in = max(max(min(x0, x1), min(y0, y1)), min(z0, z1)), out = min(min(max(x0, x1), max(y0, y1)), max(z0, z1));
        float t = in >= tNear ? in : out;
        return in <= out ? t : -1.0f;
    }
};
struct CircleShape {
    V c, n; float r;
    float cross(float ox, float oy, float oz, float dx, float dy, float dz, float, float) const {
        float t = ((c.x - ox) * n.x + (c.y - oy) * n.y + (c.z - oz) * n.z) / (dx * n.x + dy * n.y + dz * n.z);
        float x = ox + t * dx - c.x, y = oy + t * dy - c.y, z = oz + t * dz - c.z;
        return x * x + y * y + z * z <= r * r ? t : -1.0f;
    }
};
struct TriangleShape { V a, b, c; };
struct MeshShape { int model; vector<V> vertices; vector<uint32_t> indices; };

template <class S> struct Group { vector<S> shapes; vector<int> models; };

static struct {
    V p, u, v, w, background;
    float h, zNear, zFar, bias, reach;
    int width, height, byDistance, center;
    Group<PlaneShape> planes;
    Group<SphereShape> spheres;
    Group<BoxShape> boxes;
    Group<CircleShape> circles;
    Group<TriangleShape> triangles;
    vector<MeshShape> meshes;
    vector<V> colors;
} scene;

static void read(FILE* f, void* to, size_t bytes) { if (bytes && fread(to, bytes, 1, f) != 1) fail("the scene's file is too short"); }
template <class T> static T read(FILE* f) { T value; read(f, &value, sizeof value); return value; }

static void readScene(const char* path) {
    FILE* f = fopen(path, "rb");
    if (!f) fail("cannot open the scene");
    read(f, &scene.p, 5 * sizeof(V));
    read(f, &scene.h, 5 * sizeof(float));
    read(f, &scene.width, 4 * sizeof(int));
    int models = read<int>(f);
    for (int i = 0; i < models; i++) {
        int type = read<int>(f);
        scene.colors.push_back(read<V>(f));
        switch (type) {
            case 0: scene.planes.shapes.push_back(read<PlaneShape>(f)); scene.planes.models.push_back(i); break;
            case 1: scene.spheres.shapes.push_back(read<SphereShape>(f)); scene.spheres.models.push_back(i); break;
            case 2: scene.boxes.shapes.push_back(read<BoxShape>(f)); scene.boxes.models.push_back(i); break;
            case 3: scene.circles.shapes.push_back(read<CircleShape>(f)); scene.circles.models.push_back(i); break;
            case 4: scene.triangles.shapes.push_back(read<TriangleShape>(f)); scene.triangles.models.push_back(i); break;
            case 5: {
                MeshShape mesh{i, vector<V>(read<int>(f)), vector<uint32_t>()};
                mesh.indices.resize(3 * (size_t)read<int>(f));
                read(f, mesh.vertices.data(), mesh.vertices.size() * sizeof(V));
                read(f, mesh.indices.data(), mesh.indices.size() * sizeof(uint32_t));
                scene.meshes.push_back(move(mesh));
                break;
            }
            default: fail("unknown type of model");
        }
    }
    fclose(f);
}

/// The one layout of PLY that the benchmark writes: little-endian float x, y, z and faces of a uchar 3 and three ints.
static MeshShape readPly(const char* path) {
    FILE* f = fopen(path, "rb");
    if (!f) fail("cannot open the PLY");
    char line[256];
    int vertices = 0, faces = 0;
    while (fgets(line, sizeof line, f) && strcmp(line, "end_header\n")) {
        sscanf(line, "element vertex %d", &vertices);
        sscanf(line, "element face %d", &faces);
    }
    MeshShape mesh{0, vector<V>(vertices), vector<uint32_t>(3 * (size_t)faces)};
    read(f, mesh.vertices.data(), mesh.vertices.size() * sizeof(V));
    vector<unsigned char> raw(13 * (size_t)faces);
    read(f, raw.data(), raw.size());
    for (size_t i = 0; i < (size_t)faces; i++) memcpy(&mesh.indices[3 * i], &raw[13 * i + 1], 12);
    fclose(f);
    return mesh;
}

// ----------------------------------------------------------------------------------------------------------- user geometries

template <class S, int N> static void crossLanes(const RTCIntersectFunctionNArguments* a, const S s) {
    auto& rays = *(RTCRayHitNt<N>*)a->rayhit;
    auto& ray = rays.ray;
    auto& hit = rays.hit;
    const int* valid = a->valid;
    const unsigned geometry = a->geomID, primitive = a->primID;
    for (int i = 0; i < N; i++) {
        float t = s.cross(ray.org_x[i], ray.org_y[i], ray.org_z[i], ray.dir_x[i], ray.dir_y[i], ray.dir_z[i], ray.tnear[i], ray.tfar[i]);
        bool nearer = (valid[i] != 0) & (t >= ray.tnear[i]) & (t < ray.tfar[i]);
        ray.tfar[i] = nearer ? t : ray.tfar[i];
        hit.geomID[i] = nearer ? geometry : hit.geomID[i];
        hit.primID[i] = nearer ? primitive : hit.primID[i];
    }
}

template <class S> static void cross(const RTCIntersectFunctionNArguments* a) {
    const S s = ((const S*)a->geometryUserPtr)[a->primID];
    switch (a->N) {
        case 1: crossLanes<S, 1>(a, s); break;
        case 4: crossLanes<S, 4>(a, s); break;
        case 8: crossLanes<S, 8>(a, s); break;
        case 16: crossLanes<S, 16>(a, s); break;
        default: fail("an unexpected number of rays");
    }
}

static void add(RTCBounds& b, V p) {
    b.lower_x = min(b.lower_x, p.x); b.lower_y = min(b.lower_y, p.y); b.lower_z = min(b.lower_z, p.z);
    b.upper_x = max(b.upper_x, p.x); b.upper_y = max(b.upper_y, p.y); b.upper_z = max(b.upper_z, p.z);
}

/// All that the camera can see in a picture of up to twice its height's width: planes end there.
static RTCBounds seen() {
    RTCBounds b{scene.p.x, scene.p.y, scene.p.z, 0, scene.p.x, scene.p.y, scene.p.z, 0};
    float half = scene.h / 2, w = half * max(2.0f, (float)scene.width / scene.height);
    for (int i = 0; i < 4; i++)
        add(b, scene.p + scene.zFar * ((i & 1 ? w : -w) * scene.u + (i & 2 ? half : -half) * scene.v + -1.0f * scene.w));
    return b;
}

/// The axis that a plane's normal follows, or −1.
static int axisOf(const PlaneShape& s) {
    if (s.n.y == 0 && s.n.z == 0) return 0;
    if (s.n.x == 0 && s.n.z == 0) return 1;
    return s.n.x == 0 && s.n.y == 0 ? 2 : -1;
}

static RTCBounds around(V c, float r) { return {c.x - r, c.y - r, c.z - r, 0, c.x + r, c.y + r, c.z + r, 0}; }
static RTCBounds boundsOf(const SphereShape& s) { return around(s.c, s.r); }
static RTCBounds boundsOf(const BoxShape& s) { return {s.lo.x, s.lo.y, s.lo.z, 0, s.hi.x, s.hi.y, s.hi.z, 0}; }
static RTCBounds boundsOf(const CircleShape& s) {
    float length = sqrtf(s.n.x * s.n.x + s.n.y * s.n.y + s.n.z * s.n.z);
    V n = 1 / length * s.n;
    float x = s.r * sqrtf(max(0.f, 1 - n.x * n.x)) + 1e-5f, y = s.r * sqrtf(max(0.f, 1 - n.y * n.y)) + 1e-5f;
    float z = s.r * sqrtf(max(0.f, 1 - n.z * n.z)) + 1e-5f;
    return {s.c.x - x, s.c.y - y, s.c.z - z, 0, s.c.x + x, s.c.y + y, s.c.z + z, 0};
}
static RTCBounds boundsOf(const PlaneShape& s) {
    RTCBounds b = seen();
    switch (axisOf(s)) {
        case 0: b.lower_x = s.q.x - 1e-4f; b.upper_x = s.q.x + 1e-4f; break;
        case 1: b.lower_y = s.q.y - 1e-4f; b.upper_y = s.q.y + 1e-4f; break;
        case 2: b.lower_z = s.q.z - 1e-4f; b.upper_z = s.q.z + 1e-4f; break;
    }
    return b;
}
template <class S> static void bounds(const RTCBoundsFunctionArguments* a) { *a->bounds_o = boundsOf(((const S*)a->geometryUserPtr)[a->primID]); }

// -------------------------------------------------------------------------------------------------------------- hierarchies

struct Accelerator {
    RTCDevice device = nullptr;
    RTCScene handle = nullptr;
    vector<const int*> models; // by geometry: the model of each primitive, or null where all are one model
    vector<int> model;
    double milliseconds = 0;
};

static int buildThreads = 1;
static RTCBuildQuality quality = RTC_BUILD_QUALITY_HIGH;

struct Builder {
    Accelerator& a;
    int add(RTCGeometry g, const int* models, int model = -1) {
        rtcSetGeometryBuildQuality(g, quality);
        rtcCommitGeometry(g);
        rtcAttachGeometry(a.handle, g);
        rtcReleaseGeometry(g);
        a.models.push_back(models);
        a.model.push_back(model);
        return 0;
    }
    template <class S> void user(const Group<S>& group) {
        if (group.shapes.empty()) return;
        RTCGeometry g = rtcNewGeometry(a.device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(g, group.shapes.size());
        rtcSetGeometryUserData(g, (void*)group.shapes.data());
        rtcSetGeometryBoundsFunction(g, [](const RTCBoundsFunctionArguments* b) { bounds<S>(b); }, nullptr);
        rtcSetGeometryIntersectFunction(g, [](const RTCIntersectFunctionNArguments* c) { cross<S>(c); });
        add(g, group.models.data());
    }
    void triangles(const V* vertices, size_t vertexCount, const uint32_t* indices, size_t count, const int* models, int model) {
        RTCGeometry g = rtcNewGeometry(a.device, RTC_GEOMETRY_TYPE_TRIANGLE);
        memcpy(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(V), vertexCount), vertices, vertexCount * sizeof(V));
        memcpy(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count), indices, count * 12);
        add(g, models, model);
    }
    void quads(const vector<V>& corners, const vector<int>* models) {
        if (corners.empty()) return;
        RTCGeometry g = rtcNewGeometry(a.device, RTC_GEOMETRY_TYPE_QUAD);
        memcpy(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(V), corners.size()), corners.data(), corners.size() * sizeof(V));
        auto* index = (uint32_t*)rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 16, corners.size() / 4);
        for (size_t i = 0; i < corners.size(); i++) index[i] = i;
        add(g, models->data());
    }
    void points(RTCGeometryType type, const vector<float>& places, const vector<V>& normals, const vector<int>& models) {
        if (models.empty()) return;
        RTCGeometry g = rtcNewGeometry(a.device, type);
        memcpy(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, models.size()), places.data(), places.size() * 4);
        if (!normals.empty())
            memcpy(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3, 12, models.size()), normals.data(), normals.size() * 12);
        add(g, models.data());
    }
};

/// The four corners of a box's side, or of an axis-aligned plane within what is seen.
static void side(vector<V>& corners, int axis, float at, V lo, V hi) {
    for (int i = 0; i < 4; i++) {
        bool first = i == 1 || i == 2, second = i >= 2;
        float a[3] = {lo.x, lo.y, lo.z};
        const float h[3] = {hi.x, hi.y, hi.z};
        a[axis] = at;
        if (first) a[(axis + 1) % 3] = h[(axis + 1) % 3];
        if (second) a[(axis + 2) % 3] = h[(axis + 2) % 3];
        corners.push_back({a[0], a[1], a[2]});
    }
}

static unique_ptr<Accelerator> build(const string& isa, const string& flags, const string& shapes) {
    auto a = make_unique<Accelerator>();
    string config = "threads=" + to_string(buildThreads) + (isa == "best" ? "" : ",isa=" + isa);
    a->device = rtcNewDevice(config.c_str());
    if (!a->device) fail("no device for " + config);
    double start = now();
    a->handle = rtcNewScene(a->device);
    rtcSetSceneFlags(a->handle, flags == "compact" ? RTC_SCENE_FLAG_COMPACT : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(a->handle, quality);
    Builder b{*a};
    static vector<vector<int>> kept; // Embree's quads have models of their own
    kept.reserve(1000);
    if (shapes == "native") {
        RTCBounds all = seen();
        vector<V> corners;
        kept.emplace_back();
        auto* models = &kept.back();
        for (size_t i = 0; i < scene.planes.shapes.size(); i++) {
            auto& s = scene.planes.shapes[i];
            int axis = axisOf(s);
            if (axis < 0) fail("a native plane must follow the axes");
            side(corners, axis, axis == 0 ? s.q.x : axis == 1 ? s.q.y : s.q.z,
                {all.lower_x, all.lower_y, all.lower_z}, {all.upper_x, all.upper_y, all.upper_z});
            models->push_back(scene.planes.models[i]);
        }
        for (size_t i = 0; i < scene.boxes.shapes.size(); i++) {
            auto& s = scene.boxes.shapes[i];
            const float lo[3] = {s.lo.x, s.lo.y, s.lo.z}, hi[3] = {s.hi.x, s.hi.y, s.hi.z};
            for (int j = 0; j < 6; j++) {
                side(corners, j / 2, j % 2 ? hi[j / 2] : lo[j / 2], s.lo, s.hi);
                models->push_back(scene.boxes.models[i]);
            }
        }
        b.quads(corners, models);
        vector<float> places;
        for (auto& s : scene.spheres.shapes) places.insert(places.end(), {s.c.x, s.c.y, s.c.z, s.r});
        b.points(RTC_GEOMETRY_TYPE_SPHERE_POINT, places, {}, scene.spheres.models);
        places.clear();
        vector<V> normals;
        for (auto& s : scene.circles.shapes) {
            places.insert(places.end(), {s.c.x, s.c.y, s.c.z, s.r});
            normals.push_back(s.n);
        }
        b.points(RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT, places, normals, scene.circles.models);
    } else {
        b.user(scene.planes);
        b.user(scene.spheres);
        b.user(scene.boxes);
        b.user(scene.circles);
    }
    if (!scene.triangles.shapes.empty()) {
        vector<uint32_t> indices(3 * scene.triangles.shapes.size());
        for (size_t i = 0; i < indices.size(); i++) indices[i] = i;
        b.triangles(&scene.triangles.shapes[0].a, indices.size(), indices.data(), indices.size() / 3, scene.triangles.models.data(), -1);
    }
    for (auto& m : scene.meshes) b.triangles(m.vertices.data(), m.vertices.size(), m.indices.data(), m.indices.size() / 3, nullptr, m.model);
    rtcCommitScene(a->handle);
    a->milliseconds = now() - start;
    if (rtcGetDeviceError(a->device) != RTC_ERROR_NONE) fail("Embree reports an error");
    return a;
}

// ------------------------------------------------------------------------------------------------------------------ tracing

constexpr int Side = 16, Rays = Side * Side; // a tile: the stream's 256 rays

/// Where the rays of a tile stand: blocks of 4 x 2 pixels, so that each packet of 8 and of 16 is a compact one.
static struct Order {
    alignas(64) float x[Rays], y[Rays];
    int pixel[Rays]; // in the tile, line by line
    Order() {
        for (int i = 0; i < Rays; i++) {
            int lane = i % 8, block = i / 8 % 2, four = i / 16;
            int cx = four % 4 * 4 + lane % 4, cy = four / 4 * 4 + block * 2 + lane / 4;
            x[i] = cx; y[i] = cy; pixel[i] = cy * Side + cx;
        }
    }
} order;

struct Output {
    vector<float> t;
    vector<int> model;
    vector<unsigned char> rgb;
} output;

struct Trace {
    const Accelerator& a;
    string call;
    bool bytes;
    RTCIntersectContext context;
    // Of the camera, in the picture's units: d = corner + column * stepX + line * stepY, not yet of length 1.
    V corner, stepX, stepY;

    Trace(const Accelerator& a, const string& call, bool bytes) : a(a), call(call), bytes(bytes) {
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        float w = scene.h * scene.width / scene.height, shift = scene.center ? 0.5f : 0;
        stepX = w / scene.width * scene.u;
        stepY = -scene.h / scene.height * scene.v;
        corner = (w * shift / scene.width - w / 2) * scene.u + (scene.h * (scene.height - 1 + shift) / scene.height - scene.h / 2) * scene.v + -1.0f * scene.w;
    }

    /// The rays of a packet or of the tile.
    template <int N> void aim(float* ox, float* oy, float* oz, float* tn, float* dx, float* dy, float* dz, float* tf, int first, V at) const {
        for (int i = 0; i < N; i++) {
            float x = order.x[first + i], y = order.y[first + i];
            float vx = at.x + x * stepX.x + y * stepY.x, vy = at.y + x * stepX.y + y * stepY.y, vz = at.z + x * stepX.z + y * stepY.z;
            float square = vx * vx + vy * vy + vz * vz, inverse = 1 / sqrtf(square), z = scene.byDistance ? 1 : inverse * square;
            ox[i] = scene.p.x; oy[i] = scene.p.y; oz[i] = scene.p.z;
            dx[i] = vx * inverse; dy[i] = vy * inverse; dz[i] = vz * inverse;
            tn[i] = max(scene.bias, scene.zNear * z); // depth is t over the length of d
            tf[i] = scene.zFar * z;
        }
    }

    int modelOf(unsigned geometry, unsigned primitive) const {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return -1;
        const int* models = a.models[geometry];
        return models ? models[primitive] : a.model[geometry];
    }

    template <int N> void keep(const float* tf, const unsigned* geometry, const unsigned* primitive, int first, float* t, int* model) const {
        for (int i = 0; i < N; i++) {
            int p = order.pixel[first + i];
            t[p] = tf[i];
            model[p] = modelOf(geometry[i], primitive[i]);
        }
    }

    /// The blocks of 4 x 4 rays of a tile that are in the picture, each by its first ray.
    struct Blocks { int count = 0, first[16]; };

    template <class P, int N, class Call> void packets(const Blocks& blocks, V at, float* t, int* model, Call intersect) const {
        alignas(64) P p;
        alignas(64) int valid[N];
        fill(valid, valid + N, -1);
        for (int j = 0; j < blocks.count * 16 / N; j++) {
            int first = blocks.first[j * N / 16] + j * N % 16;
            aim<N>(p.ray.org_x, p.ray.org_y, p.ray.org_z, p.ray.tnear, p.ray.dir_x, p.ray.dir_y, p.ray.dir_z, p.ray.tfar, first, at);
            for (int i = 0; i < N; i++) { p.ray.mask[i] = ~0u; p.ray.flags[i] = 0; p.ray.time[i] = 0; p.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID; }
            intersect(valid, &p);
            keep<N>(p.ray.tfar, p.hit.geomID, p.hit.primID, first, t, model);
        }
    }

    template <int N> void stream(const Blocks& blocks, V at, float* t, int* model) const {
        alignas(64) RTCRayHitNt<N> p[Rays / N];
        const int count = blocks.count * 16 / N;
        auto firstOf = [&](int j) { return blocks.first[j * N / 16] + j * N % 16; };
        for (int j = 0; j < count; j++) {
            auto& r = p[j].ray;
            aim<N>(r.org_x, r.org_y, r.org_z, r.tnear, r.dir_x, r.dir_y, r.dir_z, r.tfar, firstOf(j), at);
            for (int i = 0; i < N; i++) { r.mask[i] = ~0u; r.flags[i] = 0; r.time[i] = 0; p[j].hit.geomID[i] = RTC_INVALID_GEOMETRY_ID; }
        }
        auto c = context;
        rtcIntersectNM(a.handle, &c, (RTCRayHitN*)p, N, count, sizeof p[0]);
        for (int j = 0; j < count; j++) keep<N>(p[j].ray.tfar, p[j].hit.geomID, p[j].hit.primID, firstOf(j), t, model);
    }

    void tile(int x0, int y0) const {
        alignas(64) float t[Rays];
        alignas(64) int model[Rays];
        V at = corner + (float)x0 * stepX + (float)y0 * stepY;
        Blocks blocks;
        for (int i = 0; i < 16; i++)
            if (x0 + i % 4 * 4 < scene.width && y0 + i / 4 * 4 < scene.height) blocks.first[blocks.count++] = 16 * i;
        if (blocks.count < 16) { fill(t, t + Rays, 0); fill(model, model + Rays, -1); }
        if (call == "8") {
            packets<RTCRayHit8, 8>(blocks, at, t, model, [&](int* valid, RTCRayHit8* p) { auto c = context; rtcIntersect8(valid, a.handle, &c, p); });
        } else if (call == "16") {
            packets<RTCRayHit16, 16>(blocks, at, t, model, [&](int* valid, RTCRayHit16* p) { auto c = context; rtcIntersect16(valid, a.handle, &c, p); });
        } else if (call == "nm8") {
            stream<8>(blocks, at, t, model);
        } else if (call == "nm16") {
            stream<16>(blocks, at, t, model);
        } else {
            const int rays = 16 * blocks.count;
            alignas(64) float f[8][Rays];
            for (int j = 0; j < rays; j += 16)
                aim<16>(&f[0][j], &f[1][j], &f[2][j], &f[3][j], &f[4][j], &f[5][j], &f[6][j], &f[7][j], blocks.first[j / 16], at);
            auto c = context;
            if (call == "np") {
                alignas(64) float time[Rays], scratch[5][Rays];
                alignas(64) unsigned mask[Rays], id[Rays], flags[Rays], geometry[Rays], primitive[Rays], instance[Rays];
                for (int i = 0; i < rays; i++) { mask[i] = ~0u; flags[i] = 0; time[i] = 0; geometry[i] = RTC_INVALID_GEOMETRY_ID; }
                RTCRayHitNp p{{f[0], f[1], f[2], f[3], f[4], f[5], f[6], time, f[7], mask, id, flags},
                    {scratch[0], scratch[1], scratch[2], scratch[3], scratch[4], primitive, geometry, {instance}}};
                rtcIntersectNp(a.handle, &c, &p, rays);
                for (int j = 0; j < rays; j += 16) keep<16>(&f[7][j], &geometry[j], &primitive[j], blocks.first[j / 16], t, model);
            } else {
                alignas(64) RTCRayHit r[Rays];
                for (int i = 0; i < rays; i++) {
                    r[i].ray = {f[0][i], f[1][i], f[2][i], f[3][i], f[4][i], f[5][i], f[6][i], 0, f[7][i], ~0u, (unsigned)i, 0};
                    r[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
                }
                rtcIntersect1M(a.handle, &c, r, rays, sizeof r[0]);
                for (int i = 0; i < rays; i++) keep<1>(&r[i].ray.tfar, &r[i].hit.geomID, &r[i].hit.primID, blocks.first[i / 16] + i % 16, t, model);
            }
        }
        write(x0, y0, t, model);
    }

    void write(int x0, int y0, const float* t, const int* model) const {
        int columns = min(Side, scene.width - x0), lines = min(Side, scene.height - y0);
        for (int y = 0; y < lines; y++, t += Side, model += Side) {
            size_t to = (size_t)(y0 + y) * scene.width + x0;
            if (!bytes) {
                memcpy(&output.t[to], t, columns * sizeof(float));
                memcpy(&output.model[to], model, columns * sizeof(int));
                continue;
            }
            // Four bytes are stored for a pixel, of which the next overwrites one; the last of the line stores three.
            alignas(64) uint32_t color[Side];
            const float perReach = 1 / scene.reach;
            const V* colors = scene.colors.data();
            for (int x = 0; x < Side; x++) {
                bool hit = model[x] >= 0;
                V c = colors[hit ? model[x] : 0];
                float light = hit ? max(0.0f, 1 - t[x] * perReach) : 1.0f;
                c = {hit ? c.x : scene.background.x, hit ? c.y : scene.background.y, hit ? c.z : scene.background.z};
                auto r = (int)(min(1.0f, light * c.x) * 255 + 0.5f), g = (int)(min(1.0f, light * c.y) * 255 + 0.5f);
                auto b = (int)(min(1.0f, light * c.z) * 255 + 0.5f);
                color[x] = r | g << 8 | b << 16;
            }
            unsigned char* rgb = &output.rgb[3 * to];
            for (int x = 0; x < columns - 1; x++) memcpy(rgb + 3 * x, &color[x], 4);
            memcpy(rgb + 3 * (columns - 1), &color[columns - 1], 3);
        }
    }
};

/// Threads that wait between pictures.
class Pool {
    vector<thread> threads;
    mutex lock;
    condition_variable wake, done;
    function<void()> job;
    int wanted = 0, working = 0;
    unsigned round = 0;

    void work(int me) {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
        unsigned seen = 0;
        while (true) {
            unique_lock<mutex> hold(lock);
            wake.wait(hold, [&] { return round != seen; });
            seen = round;
            if (me >= wanted) continue;
            hold.unlock();
            job();
            hold.lock();
            if (--working == 0) done.notify_one();
        }
    }

public:
    void run(int count, const function<void()>& j) {
        {
            lock_guard<mutex> hold(lock);
            while ((int)threads.size() < count - 1) threads.emplace_back([this, me = (int)threads.size()] { work(me); }).detach();
            job = j; wanted = working = count - 1;
            round++;
        }
        if (count > 1) wake.notify_all();
        j();
        unique_lock<mutex> hold(lock);
        done.wait(hold, [&] { return working == 0; });
    }
};

static Pool* pool = new Pool; // never destroyed: its threads wait in it when the program ends

static double trace(const Accelerator& a, const string& call, bool bytes, int threads) {
    size_t pixels = (size_t)scene.width * scene.height;
    if (bytes) output.rgb.resize(3 * pixels);
    else { output.t.resize(pixels); output.model.resize(pixels); }
    auto clock = threads == 1 ? threadTime : now;
    double start = clock();
    Trace t(a, call, bytes);
    int across = (scene.width + Side - 1) / Side, down = (scene.height + Side - 1) / Side;
    constexpr int Grain = 8; // tiles in a row that a thread takes at once
    int parts = (across + Grain - 1) / Grain;
    atomic<int> next{0};
    pool->run(threads, [&] {
        for (int i; (i = next++) < parts * down;)
            for (int x = i % parts * Grain; x < min(across, (i % parts + 1) * Grain); x++) t.tile(x * Side, i / parts * Side);
    });
    return clock() - start;
}

int main(int argc, char** argv) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    if (argc < 3) fail("usage: embree_peer SCENE BUILD-THREADS [PLY WIDTH HEIGHT QUALITY]");
    buildThreads = atoi(argv[2]);
    readScene(argv[1]);
    if (argc == 7) {
        quality = argv[6] == string("low") ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
        scene.width = atoi(argv[4]);
        scene.height = atoi(argv[5]);
        scene.colors.assign(1, {1, 1, 1});
        scene.meshes.push_back(readPly(argv[3]));
        auto a = build("best", "none", "user");
        trace(*a, "nm16", true, buildThreads);
        unsigned sum = 0;
        for (auto b : output.rgb) sum += b;
        cout << "sum " << sum << endl;
        _Exit(0); // Embree need not tidy up
    }
    map<string, unique_ptr<Accelerator>> built;
    auto accelerator = [&](istringstream& words) -> Accelerator& {
        string isa, flags, shapes;
        words >> isa >> flags >> shapes;
        auto& a = built[isa + " " + flags + " " + shapes];
        if (!a) a = build(isa, flags, shapes);
        return *a;
    };
    for (string line; getline(cin, line);) {
        istringstream words(line);
        string command, call, answer;
        int threads;
        words >> command;
        if (command == "size") {
            words >> scene.width >> scene.height;
            cout << "ok" << endl;
        } else if (command == "build") {
            cout << accelerator(words).milliseconds << endl;
        } else if (command == "run") {
            auto& a = accelerator(words);
            words >> call >> answer >> threads;
            cout << trace(a, call, answer == "bytes", threads) << endl;
        } else if (command == "dump") {
            auto& a = accelerator(words);
            string path;
            words >> call >> path;
            trace(a, call, false, 1);
            FILE* f = fopen(path.c_str(), "wb");
            if (!f) fail("cannot write the hits");
            fwrite(output.t.data(), sizeof(float), output.t.size(), f);
            fwrite(output.model.data(), sizeof(int), output.model.size(), f);
            fclose(f);
            cout << "ok" << endl;
        } else {
            fail("unknown command " + command);
        }
    }
    _Exit(0);
}
