using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;

namespace RayCaster.Files;

/// <summary>
/// A short name of everything that a picture depends on (SHA-256): scenes with the same digest have the same picture, to the last bit. It is made
/// of the values and
/// not of the file: comments, blanks, names, the order of keys, defaults written out or left out and where the mesh files lie do not change it.
/// </summary>
/// <remarks>
/// What goes in, in this order; a number is the eight bytes of a double, the lowest first, a text is its length and its UTF-8:
/// the text "raycaster picture 1"; width, height; position, target, up; fovY, h = 2 tan(fovY / 2); zNear, zFar, bias; clip and sample as 0 or 1; the
/// background; how many models there are, and of each its colour, the kind, and what the shape depends on: a primitive its numbers,
/// a mesh how many vertices and indices there are, and each of them, after it has been scaled, turned and moved; a model in plain doubles
/// and ifs its <see cref="Model.Numbers"/>.
/// The only functions on the way from a scene file to these numbers whose last bit may depend on the system are tan, sin and cos. That is why h
/// is in it and
/// a mesh as it is placed: where two systems differ, their digests do.
/// </remarks>
public sealed class SceneDigest : IModelVisitor, IDisposable
{
    private readonly IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);

    private SceneDigest()
    {
    }

    /// <summary>The digest of a scene: 64 hexadecimal digits, small letters.</summary>
    /// <exception cref="NotSupportedException">A model does not say what it is made of; the message is for people.</exception>
    public static string Of(Scene scene)
    {
        using var digest = new SceneDigest();
        var camera = scene.Camera;
        digest.Add("raycaster picture 1").Add(camera.Width).Add(camera.Height)
            .Add(camera.Position).Add(camera.Target).Add(camera.Up).Add(camera.FovY).Add(camera.PlaneHeight)
            .Add(camera.ZNear).Add(camera.ZFar).Add(camera.Bias).Add((int)camera.Clip).Add((int)camera.Sample)
            .Add(scene.Background).Add(scene.Models.Count);
        for (var i = 0; i < scene.Models.Count; i++)
        {
            try
            {
                digest.Add(scene.Models[i].Color);
                scene.Models[i].Accept(digest);
            }
            catch (NotSupportedException e)
            {
                throw new NotSupportedException($"models[{i}] {e.Message}", e);
            }
        }
        return Convert.ToHexStringLower(digest.hash.GetHashAndReset());
    }

    void IModelVisitor.Visit<P>(Model<P> model) => Add(typeof(P).Name).AddBits([model.Primitive]);

    void IModelVisitor.Visit(Mesh mesh) =>
        Add("Mesh").Add(mesh.Vertices.Length).Add(mesh.Indices.Length).AddBits<Vector3>(mesh.Vertices).AddBits<int>(mesh.Indices);

    void IModelVisitor.VisitOther(Model model)
    {
        Add(model.GetType().Name);
        foreach (var number in model.Numbers ?? throw Unknown(model.GetType())) Add(number);
    }

    /// <summary>Adds a number.</summary>
    private SceneDigest Add(double number) => AddBits([number]);

    /// <summary>Adds three numbers.</summary>
    private SceneDigest Add(Vector3 vector) => AddBits([vector]);

    /// <summary>Adds red, green and blue.</summary>
    private SceneDigest Add(Color color) => AddBits([color]);

    /// <summary>Adds a text.</summary>
    private SceneDigest Add(string text)
    {
        var utf8 = Encoding.UTF8.GetBytes(text);
        Add(utf8.Length);
        hash.AppendData(utf8);
        return this;
    }

    /// <summary>Adds the bits of values.</summary>
    private SceneDigest AddBits<T>(ReadOnlySpan<T> values) where T : struct
    {
        if (RuntimeHelpers.IsReferenceOrContainsReferences<T>()) throw Unknown(typeof(T));
        for (; values.Length > 0; values = values[Math.Min(values.Length, 1 << 20)..]) // bytes are counted by an int
            hash.AppendData(MemoryMarshal.AsBytes(values[..Math.Min(values.Length, 1 << 20)]));
        return this;
    }

    /// <summary>What is thrown for a model of which nothing is known.</summary>
    private static NotSupportedException Unknown(Type type) => new(
        $"is of the class {type.Name}, which does not say what it is made of; have it override Numbers (docs/adding-a-primitive.md)");

    /// <summary>Frees what the hash holds.</summary>
    public void Dispose() => hash.Dispose();
}
