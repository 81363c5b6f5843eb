namespace RayCaster.Engine;

/// <summary>Where the hits of a model in a tile lie.</summary>
/// <param name="Least">No hit is nearer; +∞ if there is none.</param>
/// <param name="Cover">Every pixel of the tile certainly has a hit at most this far; +∞ if that is not certain.</param>
/// <param name="IsNear">Every hit is certainly the shape's first crossing, so there is nothing to choose or clip.</param>
internal readonly record struct HitRange(double Least, double Cover, bool IsNear = false)
{
    public static HitRange None => new(double.PositiveInfinity, double.PositiveInfinity);
}

/// <summary>Where the hits of a model in eight parts lie (<see cref="HitRange"/>), a lane for each.</summary>
internal readonly struct HitRanges(WidePacket least, WidePacket cover, WidePacket isNear)
{
    /// <summary>The same in all parts.</summary>
    public HitRanges(HitRange all) : this(all.Least, all.Cover, 0) { }

    // a mask's sign bit is its truth value
    public HitRange this[int part] => new(least.Lanes[part], cover.Lanes[part], double.IsNegative(isNear.Lanes[part]));
}
