using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// A part of the picture in which all rays surely hit some shapes, and nothing else can be nearer. Where there is but one shape, each ray is met as soon as it is aimed,
/// and nothing but t is kept.
/// </summary>
internal sealed class CoveredPart(Frame frame)
{
    private readonly Camera camera = frame.Scene.Camera;
    private readonly Columns columns = new(frame.Scene.Camera, Tile.MaxStrip);

    /// <summary>The part.</summary>
    public Tile Part { get; private set; }

    /// <summary>Paints the part without exact hits; made when it is first asked for.</summary>
    public RoughPainter Painter => field ??= new(frame);

    /// <summary>The shapes.</summary>
    public List<CoveringShape> Shapes { get; } = [];

    /// <summary>Comes to a part, whose shapes are to be told then.</summary>
    public void Enter(in Tile part)
    {
        Part = part;
        Shapes.Clear();
    }

    /// <summary>Writes down where the rays of a part of at least a packet's width hit a shape that all of them hit.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="t">Room for the ray parameters.</param>
    /// <param name="first">The place of the lowest row's first pixel; the others of the row follow.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    /// <typeparam name="N">The kind of packet to compute with.</typeparam>
    /// <typeparam name="P">The kind of shape.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)] // a picture is often drawn before the runtime would optimise by itself
    public void Hit<N, P>(P shape, double[] t, int first, int step) where N : struct, IPacket<N> where P : struct, IPrimitive
    {
        columns.Enter<N>(Part.Column, Part.Width);
        Vector3<N> origin = camera.Position;
        var isNear = Shapes[0].IsNear;
        var (width, end) = (Part.Width, Part.EndRow);
        for (var row = Part.Row; row < end; row++, first += step)
        {
            var upwards = camera.Upwards(Lanes.Broadcast<N>(row));
            for (var next = 0; next < width; next += N.Count)
            {
                var i = Math.Min(next, width - N.Count); // the last packet may overlap the one before: a call for what is left would cost the loop its registers
                var direction = camera.Direction(columns.At<N>(i), upwards);
                var crossings = shape.Cross(new Ray<N>(origin, direction));
                var hit = isNear ? crossings.Near : camera.ClipRange.First(crossings, camera.ZPerT(direction));
                hit.Store(t, first + i);
            }
        }
    }
}

/// <summary>A shape that all rays of a part hit.</summary>
/// <param name="View">Its view.</param>
/// <param name="Index">Its model's place in the scene.</param>
/// <param name="IsNear">Whether each hit is surely the shape's first crossing.</param>
internal readonly record struct CoveringShape(ICoveringView View, int Index, bool IsNear);
