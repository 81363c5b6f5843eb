namespace RayCaster.Engine;

/// <summary>Where the hits of a model in a tile lie.</summary>
/// <param name="NearestT">No hit is nearer; +∞ if there is none.</param>
/// <param name="FarthestT">Every pixel of the tile certainly has a hit at most this far; +∞ if that is not certain.</param>
/// <param name="IsFirstCrossing">Every hit is certainly the shape's first crossing, so there is nothing to choose or clip.</param>
internal readonly record struct HitRange(double NearestT, double FarthestT, bool IsFirstCrossing = false)
{
    public static HitRange None => new(double.PositiveInfinity, double.PositiveInfinity);
}

/// <summary>Where the hits of a model in eight parts lie (<see cref="HitRange"/>), a lane for each.</summary>
internal readonly struct HitRangePacket(WidePacket nearestT, WidePacket farthestT, WidePacket isFirstCrossing)
{
    /// <summary>The same in all parts.</summary>
    public HitRangePacket(HitRange all) : this(all.NearestT, all.FarthestT, 0) { }

    // a mask's sign bit is its truth value
    public HitRange this[int part] => new(nearestT.Lanes[part], farthestT.Lanes[part], double.IsNegative(isFirstCrossing.Lanes[part]));
}
