namespace RayCaster.Files;

/// <summary>What one block of a mesh file holds.</summary>
/// <param name="Indices">
/// Three corners for each triangle. A corner from 0 on is a place among all vertices of the file. A negative corner minus <see cref="Here"/> is
/// a place relative to the block's first vertex, whose own place is not known yet.
/// </param>
internal readonly record struct MeshPiece(Vector3[] Vertices, int[] Indices)
{
    /// <summary>Stands for the block's first vertex: the middle of the negative numbers.</summary>
    public const int Here = int.MinValue / 2;

    /// <summary>Joins the pieces in order. Takes each out of the list as soon as it is copied, so that its memory can be freed.</summary>
    /// <exception cref="MeshFileException">There is no face, or too many for an array, or one counts back beyond the first vertex.</exception>
    public static MeshData Join(List<MeshPiece> pieces, MeshSource source, int threads)
    {
        var (firstVertex, firstIndex) = (new long[pieces.Count + 1], new long[pieces.Count + 1]);
        for (var i = 0; i < pieces.Count; i++)
        {
            firstVertex[i + 1] = firstVertex[i] + pieces[i].Vertices.Length;
            firstIndex[i + 1] = firstIndex[i] + pieces[i].Indices.Length;
        }
        if (firstIndex[^1] == 0) throw source.Error("the file has no face; a mesh needs at least one");
        if (Math.Max(firstVertex[^1], firstIndex[^1]) > Array.MaxLength)
            throw source.Error($"the file has too many faces; at most {Array.MaxLength / 3} triangles are read");

        var vertices = GC.AllocateUninitializedArray<Vector3>((int)firstVertex[^1]);
        var indices = GC.AllocateUninitializedArray<int>((int)firstIndex[^1]);
        var isSound = true;
        Ranges.EachPiece(pieces.Count, threads, i =>
        {
            pieces[i].Vertices.CopyTo(vertices, firstVertex[i]);
            if (!pieces[i].CopyIndices(indices.AsSpan((int)firstIndex[i]), (int)firstVertex[i])) Volatile.Write(ref isSound, false);
            pieces[i] = default;
        });
        return isSound ? new(vertices, indices) : throw source.Error("a face counts back beyond the first vertex");
    }

    /// <summary>Copies the corners as places in the file; false where one counts back beyond its first vertex.</summary>
    private bool CopyIndices(Span<int> to, int firstVertex)
    {
        var least = 0;
        for (var i = 0; i < Indices.Length; i++)
        {
            to[i] = Indices[i] < 0 ? Indices[i] - Here + firstVertex : Indices[i];
            least = Math.Min(least, to[i]);
        }
        return least == 0;
    }
}
