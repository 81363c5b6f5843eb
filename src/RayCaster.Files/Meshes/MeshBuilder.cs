namespace RayCaster.Files;

/// <summary>Collects the vertices and faces of a mesh file; splits polygons into fans.</summary>
internal sealed class MeshBuilder(MeshSource source)
{
    private readonly List<Vector3> vertices = [];
    private readonly List<int> indices = [];
    private int first, previous;

    public int VertexCount => vertices.Count;

    public int CornerCount { get; private set; }

    public void AddVertex(Vector3 vertex) => vertices.Add(vertex);

    public void BeginFace() => CornerCount = 0;

    /// <summary>Adds a corner to the face. Each corner from the third on makes a triangle with the first corner and the one before.</summary>
    public void AddCorner(int vertex)
    {
        if (CornerCount == 0) first = vertex;
        if (CornerCount >= 2) AddTriangle(first, previous, vertex);
        previous = vertex;
        CornerCount++;
    }

    public void AddTriangle(int a, int b, int c)
    {
        if (indices.Count > Array.MaxLength - 3)
            throw source.Error($"the file has too many faces; at most {Array.MaxLength / 3} triangles are read");
        indices.Add(a);
        indices.Add(b);
        indices.Add(c);
    }

    /// <param name="warning">What was ignored in the file.</param>
    public MeshData Finish(string? warning = null) => indices.Count > 0
        ? new([.. vertices], [.. indices]) { Warning = warning }
        : throw source.Error("the file has no face; a mesh needs at least one");
}
