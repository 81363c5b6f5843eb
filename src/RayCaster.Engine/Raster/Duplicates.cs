namespace RayCaster.Engine;

/// <summary>
/// Recognises a triangle whose corners equal an earlier one's, to the bit and in the same order: its t is the same everywhere, so one of them is
/// enough. Otherwise a million copies of one triangle would all be intersected with each pixel's ray, since none is certainly in front.
/// </summary>
/// <remarks>It misses some, since a slot of the table holds only one triangle. It reports only duplicates of triangles that are earlier in the mesh,
/// so the first of all equal ones is never left out, in whatever order they come.</remarks>
internal sealed class Duplicates(Vector3[] vertices, int[] indices)
{
    private Vector3[] vertices = vertices;
    private int[] indices = indices;
    private readonly (int Round, int Triangle, long Hash)[] table = new (int, int, long)[1 << 10];
    private int round = 1;

    /// <summary>Sets the mesh and clears the table.</summary>
    public void SetMesh(Vector3[] vertices, int[] indices)
    {
        (this.vertices, this.indices) = (vertices, indices);
        Clear();
    }

    public void Clear() => round++;

    /// <summary>Whether a triangle that was seen before, and is earlier in the mesh, has the same corners.</summary>
    public bool HasEarlier(int triangle)
    {
        var (a, b, c) = (vertices[indices[3 * triangle]], vertices[indices[3 * triangle + 1]], vertices[indices[3 * triangle + 2]]);
        var hash = HashOf(a) + 3 * HashOf(b) + 5 * HashOf(c);
        ref var slot = ref table[(int)((ulong)(hash * -7046029254386353131) >> 54)];
        if (slot.Round == round && slot.Triangle < triangle && slot.Hash == hash && IsCorner(slot.Triangle, 0, a) && IsCorner(slot.Triangle, 1, b)
            && IsCorner(slot.Triangle, 2, c))
            return true;
        slot = (round, triangle, hash);
        return false;
    }

    private bool IsCorner(int triangle, int corner, in Vector3 point)
    {
        ref readonly var other = ref vertices[indices[3 * triangle + corner]];
        return Bits(other.X) == Bits(point.X) && Bits(other.Y) == Bits(point.Y) && Bits(other.Z) == Bits(point.Z);
    }

    private static long HashOf(in Vector3 p) => Bits(p.X) + 7 * Bits(p.Y) + 31 * Bits(p.Z);

    private static long Bits(double number) => BitConverter.DoubleToInt64Bits(number);
}
