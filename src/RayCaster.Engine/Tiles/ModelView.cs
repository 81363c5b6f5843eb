namespace RayCaster.Engine;

/// <summary>
/// A model as the camera of one picture sees it. It may say early that it does not show in a tile; which pixels it shows in, and at which t, it answers
/// by the model's own formula.
/// </summary>
internal abstract class ModelView
{
    /// <summary>Where in the picture the model can show at all.</summary>
    public virtual Tile Extent => Tile.Everywhere;

    /// <summary>No hit anywhere in the picture is nearer than this.</summary>
    public virtual double Nearest => 0;

    /// <summary>A view for the use of one thread at a time; the same one where a view keeps nothing between calls.</summary>
    /// <param name="filters">What the thread's views of meshes share.</param>
    public virtual ModelView ForThread(TileFilters? filters = null) => this;

    /// <summary>Comes to a tile, before <see cref="Meet"/> is called for rows in it: between which t the model's hits lie.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="known">What is known of that already.</param>
    public virtual HitRange Enter(in Tile tile, HitRange known) => known;

    /// <summary>Tells between which t the model's hits in some parts lie; not asked of one whose <see cref="Extent"/> is small.</summary>
    /// <param name="parts">The parts and their rays.</param>
    /// <param name="whole">What is known of all of them.</param>
    public virtual HitRanges Narrow(EightParts parts, HitRange whole) => new(whole);

    /// <summary>Keeps the hits of a span of pixels in the tile that are nearer than all before.</summary>
    /// <param name="span">The rays.</param>
    /// <param name="index">The model's place in the scene, for ties.</param>
    public abstract void Meet(RaySpan span, int index);

    /// <summary>Gives rented memory back when the picture is done; called once, of the view that <see cref="ForThread"/> was asked of.</summary>
    public virtual void Free()
    {
    }
}

/// <summary>A view that finds the hits of a part of the picture the short way where its model surely covers the part.</summary>
internal interface ICoveringView
{
    /// <inheritdoc cref="CoveredPart.Hit{N, P}"/>
    void Hit(CoveredPart covered, double[] t, int first, int step);

    /// <inheritdoc cref="RoughPainter.Paint{P}(in P, int, bool)"/>
    bool Paint(RoughPainter painter, int index, bool isNear);
}

/// <summary>A view that can finish a tile by itself, where nothing but its model may show.</summary>
internal interface ITileView
{
    /// <summary>Writes down the hits of the tile that was entered last; false if it does not suit.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="index">The model's place in the scene.</param>
    /// <param name="t">Room for the ray parameters; +∞ for no hit.</param>
    /// <param name="models">Room for the models; −1 for no hit.</param>
    /// <param name="first">The place of the lowest row's first pixel.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    bool Hit(in Tile tile, int index, double[] t, int[] models, int first, int step);

    /// <summary>Writes its bytes, mostly without asking where exactly the rays hit the model; false if it does not suit.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="index">The model's place in it.</param>
    /// <param name="rgb">Room for the bytes.</param>
    /// <param name="first">The place of the lowest row's first pixel.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    bool Paint(Scene scene, int index, byte[] rgb, int first, int step);
}
