namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>A change of one file of the lab.</summary>
/// <param name="File">The file's name, without ".cs".</param>
/// <param name="Old">What is written there, once.</param>
/// <param name="New">What a student writes in its place.</param>
internal sealed record SourceEdit(string File, string Old, string New)
{
    /// <summary>Another body for the triangle's method.</summary>
    public static SourceEdit OfTriangle(string body) =>
        new("Triangle", "public override void Intersect(Ray ray)",
            $"public sealed override void Intersect(Ray ray) {{ {body} }} void OfTheLab(Ray ray)");
}
