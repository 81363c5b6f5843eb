using System.Runtime.Intrinsics;

namespace RayCaster.Engine.Tests.Rendering;

/// <summary>A formula over a packet of either width gives each lane the bits that it gives a single double.</summary>
public class PacketTests
{
    private const int PacketsPerShape = 64;

    /// <summary>A sample; .ci/run sets RAYCASTER_SCENES: 4000 shapes · 64 packets · 4 lanes are a million rays for each primitive.</summary>
    private static readonly int shapes = int.TryParse(Environment.GetEnvironmentVariable("RAYCASTER_SCENES"), out var scenes) ? 20 * scenes : 400;

    [Fact]
    public void PlaneOverAPacketIsPlaneOverADouble() => HoldsFor(1, s => new Plane(s.Vector(), s.Vector()), p => [p.Point, p.Point + p.Normal]);

    [Fact]
    public void SphereOverAPacketIsSphereOverADouble() =>
        HoldsFor(2, s => new Sphere(s.Vector(), s.Positive()),
            p => [p.Center, p.Center + new Vector3(p.Radius, 0, 0), p.Center - new Vector3(0, 0, p.Radius)]);

    [Fact]
    public void BoxOverAPacketIsBoxOverADouble() =>
        HoldsFor(3, s => Some.Box(s.Vector(), s.Vector()), p => [p.Min, p.Max, new(p.Min.X, p.Max.Y, p.Min.Z)]);

    [Fact]
    public void CircleOverAPacketIsCircleOverADouble() =>
        HoldsFor(4, s => new Circle(s.Vector(), s.Vector(), s.Positive()),
            p => [p.Center, p.Center + p.Radius * (p.Normal % new Vector3(0, 0, 1)).Normalized]);

    [Fact]
    public void TriangleOverAPacketIsTriangleOverADouble() =>
        HoldsFor(5, s => new Triangle(s.Vector(), s.Vector(), s.Vector()), p => [p.A, p.B, p.C]);

    private static void HoldsFor<P>(int seed, Func<SpecialRays, P> shape, Func<P, Vector3[]> targets) where P : struct, IPrimitive
    {
        var special = new SpecialRays(seed);
        var hits = 0;
        var origins = new Vector3[Packet.Count];
        var directions = new Vector3[Packet.Count];
        for (var i = 0; i < shapes; i++)
        {
            var primitive = shape(special);
            var aims = targets(primitive);
            for (var j = 0; j < PacketsPerShape; j++)
            {
                for (var lane = 0; lane < Packet.Count; lane++)
                {
                    origins[lane] = special.Choose(3) == 0 ? special.Mix(aims) : special.Vector();
                    directions[lane] = special.Choose(3) == 0 ? special.Direction() : special.Towards(origins[lane], special.Mix(aims));
                }
                var packet = primitive.Intersect(new Ray<Packet>(Pack(origins), Pack(directions)));
                var wide = primitive.Intersect(new Ray<WidePacket>(Twice(Pack(origins)), Twice(Pack(directions))));
                Assert.True(AreTwice(packet.Near, wide.Near) && AreTwice(packet.Far, wide.Far),
                    $"{primitive}: the wide packet differs (RAYCASTER_SEED={Campaign.Seed})");
                for (var lane = 0; lane < Packet.Count; lane++)
                {
                    var scalar = primitive.Intersect(new Ray<Scalar>(origins[lane], directions[lane]));
                    if (Same(scalar.Near, packet.Near.Lanes[lane]) && Same(scalar.Far, packet.Far.Lanes[lane]))
                    {
                        if (!double.IsNaN(scalar.Near)) hits++;
                        continue;
                    }
                    Assert.Fail($"RAYCASTER_SEED={Campaign.Seed}: {primitive}, ray from {origins[lane]} along {directions[lane]}: " +
                        $"one double gives {scalar.Near.Value:R}, " +
                        $"{scalar.Far.Value:R}, the packet {packet.Near.Lanes[lane]:R}, {packet.Far.Lanes[lane]:R}");
                }
            }
        }
        Assert.True(hits > shapes * PacketsPerShape / 10, $"only {hits} of the rays cross the shape: they test little");
    }

    private static Vector3<WidePacket> Twice(Vector3<Packet> v) => new(Twice(v.X), Twice(v.Y), Twice(v.Z));

    private static WidePacket Twice(Packet p) => new(Vector512.Create(p.Lanes, p.Lanes));

    private static bool AreTwice(Packet narrow, WidePacket wide) =>
        Enumerable.Range(0, WidePacket.Count).All(lane => Same(narrow.Lanes[lane % Packet.Count], wide.Lanes[lane]));

    /// <summary>Equal bits, where all NaNs are one: a NaN's sign and payload never reach a picture.</summary>
    private static bool Same(double a, double b) =>
        double.IsNaN(a) ? double.IsNaN(b) : BitConverter.DoubleToInt64Bits(a) == BitConverter.DoubleToInt64Bits(b);

    private static Vector3<Packet> Pack(Vector3[] v) => new(
        new(Vector256.Create(v[0].X, v[1].X, v[2].X, v[3].X)),
        new(Vector256.Create(v[0].Y, v[1].Y, v[2].Y, v[3].Y)),
        new(Vector256.Create(v[0].Z, v[1].Z, v[2].Z, v[3].Z)));
}
