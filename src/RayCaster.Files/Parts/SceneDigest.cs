using System.Runtime.InteropServices;
using System.Security.Cryptography;

namespace RayCaster.Files;

/// <summary>
/// A hash (SHA-256) of everything that a picture depends on: scenes with the same digest have the same picture, to the last bit. It is computed
/// from the values. Comments, blanks, names, the order of keys, defaults that are written out, and the places of mesh files do not change it.
/// </summary>
/// <remarks>
/// The last bit of tan, sin and cos may depend on the system. Therefore h = 2 tan(fovY / 2) and the placed vertices are hashed: if two systems
/// compute different ones, their digests differ.
/// </remarks>
internal static class SceneDigest
{
    /// <summary>The digest of a scene: 64 hexadecimal digits, small letters.</summary>
    /// <param name="models">The digest of its models (<see cref="OfModels"/>), which all frames of a moving camera share.</param>
    public static string Compute(Scene scene, string models)
    {
        var c = scene.Camera;
        var values = FormattableString.Invariant($"""
            {c.Width} {c.Height} {c.Position} {c.Target} {c.Up} {c.FovY:R} {c.PlaneHeight:R} {c.ZNear:R} {c.ZFar:R} {c.Bias:R} {c.Clip} {c.Sample}
            {scene.Background} {models}
            """);
        return Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(values)));
    }

    /// <summary>The digest of models in their order: of the text of each, which holds its numbers, and of the arrays of meshes.</summary>
    public static string OfModels(IReadOnlyList<Model> models)
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        for (var i = 0; i < models.Count; i++)
        {
            var model = models[i];
            var mesh = model as Mesh;
            var text = mesh is null ? $"{model}" : FormattableString.Invariant($"mesh {mesh.Vertices.Length} {mesh.Indices.Length}");
            if (model.GetType().ToString().Contains(text)) // the name of a class or structure that does not override ToString
                throw new ProblemException($"the scene cannot be drawn in parts: models[{i}] is of the class {model.GetType().Name}, "
                    + "which does not say its numbers; override ToString in it (docs/adding-a-primitive.md)");
            hash.AppendData(Encoding.UTF8.GetBytes($"{model.Color} {text}\n"));
            Append<Vector3>(hash, mesh?.Vertices);
            Append<int>(hash, mesh?.Indices);
        }
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    private static void Append<T>(IncrementalHash hash, ReadOnlySpan<T> values) where T : struct
    {
        const int AtOnce = 1 << 20; // a span's bytes are counted by an int
        for (; values.Length > 0; values = values[Math.Min(values.Length, AtOnce)..])
            hash.AppendData(MemoryMarshal.AsBytes(values[..Math.Min(values.Length, AtOnce)]));
    }
}
