namespace RayCaster;

/// <summary>Collects vertices and faces; splits polygons into fans.</summary>
/// <param name="source">The file, for messages.</param>
internal sealed class MeshBuilder(MeshSource source)
{
    private Vector3[] vertices = [];
    private int[] indices = [];
    private int indexCount, first, previous;

    /// <summary>How many vertices there are.</summary>
    public int VertexCount { get; private set; }

    /// <summary>How many corners the face has that was begun last.</summary>
    public int CornerCount { get; private set; }

    /// <summary>Makes room for as many vertices; the caller has compared the number with the size of the file.</summary>
    public void ReserveVertices(int count) => Array.Resize(ref vertices, count);

    /// <summary>Makes room for as many triangles.</summary>
    public void ReserveTriangles(int count) => Array.Resize(ref indices, (int)Math.Min(3L * count, Array.MaxLength));

    public void AddVertex(Vector3 vertex)
    {
        if (VertexCount == vertices.Length) Grow(ref vertices);
        vertices[VertexCount++] = vertex;
    }

    public void BeginFace() => CornerCount = 0;

    /// <summary>Adds a corner to the face; from the third on each makes a triangle with the first corner and the one before.</summary>
    public void AddCorner(int vertex)
    {
        if (CornerCount == 0) first = vertex;
        if (CornerCount >= 2) AddTriangle(first, previous, vertex);
        previous = vertex;
        CornerCount++;
    }

    public void AddTriangle(int a, int b, int c)
    {
        if (indexCount > indices.Length - 3) Grow(ref indices);
        (indices[indexCount], indices[indexCount + 1], indices[indexCount + 2]) = (a, b, c);
        indexCount += 3;
    }

    /// <exception cref="MeshFileException">There is no face.</exception>
    public MeshData ToMesh()
    {
        if (indexCount == 0) throw source.Error("the file has no face; a mesh needs at least one");
        Array.Resize(ref vertices, VertexCount); // does nothing to an array of the right length
        Array.Resize(ref indices, indexCount);
        return new(vertices, indices);
    }

    private void Grow<T>(ref T[] array)
    {
        if (array.Length == Array.MaxLength) throw source.Error($"the file has too many faces; at most {Array.MaxLength / 3} triangles are read");
        Array.Resize(ref array, (int)Math.Clamp(2L * array.Length, 1024, Array.MaxLength));
    }
}
