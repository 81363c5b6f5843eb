namespace RayCaster.Files;

/// <summary>Collects the vertices and faces of a block; splits polygons into fans.</summary>
/// <param name="isInOrder">Whether one builder collects all blocks of the file in order, so that it can count the vertices above.</param>
internal sealed class MeshBuilder(MeshSource source, bool isInOrder)
{
    private Vector3[] vertices = [];
    private int[] indices = [];
    private int vertexCount, indexCount, first, previous;
    private long verticesBefore;
    private bool countsFromHere;

    /// <summary>How many vertices the file has up to here; null where that is not known yet.</summary>
    public long? VerticesAbove => isInOrder ? verticesBefore + vertexCount : null;

    public int CornerCount { get; private set; }

    public void AddVertex(Vector3 vertex)
    {
        if (vertexCount == vertices.Length) Grow(ref vertices);
        vertices[vertexCount++] = vertex;
    }

    public void BeginFace() => CornerCount = 0;

    /// <summary>Makes room for all triangles of one face at once: doubling the room step by step would take twice the memory.</summary>
    public void Expect(long triangles)
    {
        var needed = indexCount + 3 * triangles;
        if (triangles > 1 && needed > indices.Length && needed <= Array.MaxLength)
            Array.Resize(ref indices, (int)Math.Max(needed, Math.Min(2L * indices.Length, Array.MaxLength)));
    }

    /// <summary>Adds a corner to the face. Each corner from the third on makes a triangle with the first corner and the one before.</summary>
    /// <param name="vertex">The place among the file's vertices, from 0. A place beyond every array becomes the last int, which is one too.</param>
    public void AddCorner(long vertex) => Add((int)Math.Min(vertex, int.MaxValue));

    /// <summary>Adds a corner to the face; −1 is the vertex that was added last.</summary>
    public void AddCornerBack(long back)
    {
        if (VerticesAbove is { } above)
        {
            AddCorner(above + back);
            return;
        }
        var place = MeshPiece.Here + vertexCount + back;
        if (place is < int.MinValue or >= 0) throw source.Error("a face counts back too far to be kept until the vertices above are counted");
        countsFromHere = true;
        Add((int)place);
    }

    /// <summary>What was collected since the last piece.</summary>
    public MeshPiece TakePiece()
    {
        var piece = new MeshPiece(Copy(vertices, vertexCount), Copy(indices, indexCount), countsFromHere);
        Drop();
        return piece;
    }

    /// <summary>Forgets what was collected, but still counts its vertices.</summary>
    public void Drop()
    {
        verticesBefore += vertexCount;
        (vertexCount, indexCount, countsFromHere) = (0, 0, false);
    }

    private void Add(int corner)
    {
        if (CornerCount == 0) first = corner;
        if (CornerCount >= 2) AddTriangle(first, previous, corner);
        previous = corner;
        CornerCount++;
    }

    private void AddTriangle(int a, int b, int c)
    {
        if (indexCount > indices.Length - 3) Grow(ref indices);
        (indices[indexCount], indices[indexCount + 1], indices[indexCount + 2]) = (a, b, c);
        indexCount += 3;
    }

    private void Grow<T>(ref T[] array)
    {
        if (array.Length == Array.MaxLength)
            throw source.Error($"the mesh is too large; at most {Array.MaxLength / 3} triangles are read");
        Array.Resize(ref array, (int)Math.Clamp(2L * array.Length, 1024, Array.MaxLength));
    }

    private static T[] Copy<T>(T[] array, int count)
    {
        var copy = GC.AllocateUninitializedArray<T>(count);
        array.AsSpan(0, count).CopyTo(copy);
        return copy;
    }
}
