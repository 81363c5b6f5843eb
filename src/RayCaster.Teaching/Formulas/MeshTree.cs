namespace RayCaster.Teaching.Formulas;

/// <summary>The hierarchy of a mesh's triangles.</summary>
internal static class MeshTree
{
    private static readonly ConditionalWeakTable<Mesh, TriangleTree> trees = [];

    /// <param name="mesh">Any mesh.</param>
    extension(Mesh mesh)
    {
        /// <summary>Its hierarchy, built at the first use.</summary>
        internal TriangleTree Tree => trees.GetValue(mesh, static mesh => new(mesh.Vertices, mesh.Indices));
    }
}
