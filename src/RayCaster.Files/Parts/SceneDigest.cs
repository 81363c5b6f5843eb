using System.Runtime.InteropServices;
using System.Security.Cryptography;

namespace RayCaster.Files;

/// <summary>
/// A hash (SHA-256) of everything that a picture depends on: scenes with the same digest have the same picture, to the last bit. It is computed
/// from the values. Comments, blanks, names, the order of keys, defaults that are written out, and the places of mesh files do not change it.
/// </summary>
/// <remarks>
/// These values are hashed, in this order: the text "raycaster picture 2"; width, height; position, target, up; fovY, h = 2 tan(fovY / 2); zNear,
/// zFar, bias; clip and sample as 0 or 1; the background; the digest of the models. In that are hashed: the number of models, and of each its colour
/// and its kind. Then of a primitive its numbers; of a mesh the number of vertices and of indices, and each of them, as the scene places it; of a
/// scalar shape its <see cref="Model.Numbers"/>. A number is the eight bytes of a double, the lowest first; a text is its length
/// and its UTF-8 bytes.
/// <para>The last bit of tan, sin and cos may depend on the system. Therefore h and the placed vertices are hashed: if two systems compute
/// different ones, their digests differ.</para>
/// </remarks>
public sealed class SceneDigest : IModelVisitor
{
    private readonly IncrementalHash hash;

    private SceneDigest(IncrementalHash hash) => this.hash = hash;

    /// <summary>The digest of a scene: 64 hexadecimal digits, small letters.</summary>
    /// <param name="models">The digest of its models (<see cref="OfModels"/>), which all frames of a moving camera share.</param>
    public static string Of(Scene scene, string models)
    {
        var camera = scene.Camera;
        return Of(digest => digest.Add("raycaster picture 2").Add(camera.Width).Add(camera.Height)
            .Add(camera.Position).Add(camera.Target).Add(camera.Up).Add(camera.FovY).Add(camera.PlaneHeight)
            .Add(camera.ZNear).Add(camera.ZFar).Add(camera.Bias).Add((int)camera.Clip).Add((int)camera.Sample)
            .Add(scene.Background).Add(models));
    }

    /// <summary>The digest of models in their order.</summary>
    /// <exception cref="NotSupportedException">A model does not list its <see cref="Model.Numbers"/>; the message is for people.</exception>
    public static string OfModels(IReadOnlyList<Model> models) => Of(digest =>
    {
        digest.Add(models.Count);
        for (var i = 0; i < models.Count; i++)
        {
            try
            {
                digest.Add(models[i].Color);
                models[i].Accept(digest);
            }
            catch (NotSupportedException e)
            {
                throw new NotSupportedException($"models[{i}] {e.Message}", e);
            }
        }
    });

    private static string Of(Action<SceneDigest> add)
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        add(new(hash));
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    void IModelVisitor.Visit<P>(Model<P> model) => Add(typeof(P).Name).AddBits([model.Primitive]);

    void IModelVisitor.Visit(Mesh mesh) =>
        Add("Mesh").Add(mesh.Vertices.Length).Add(mesh.Indices.Length).AddBits<Vector3>(mesh.Vertices).AddBits<int>(mesh.Indices);

    void IModelVisitor.VisitOther(Model model)
    {
        Add(model.GetType().Name);
        foreach (var number in model.Numbers ?? throw Unknown(model.GetType())) Add(number);
    }

    private SceneDigest Add(double number) => AddBits([number]);

    private SceneDigest Add(Vector3 vector) => AddBits([vector]);

    private SceneDigest Add(Color color) => AddBits([color]);

    private SceneDigest Add(string text)
    {
        var utf8 = Encoding.UTF8.GetBytes(text);
        Add(utf8.Length);
        hash.AppendData(utf8);
        return this;
    }

    private SceneDigest AddBits<T>(ReadOnlySpan<T> values) where T : struct
    {
        if (RuntimeHelpers.IsReferenceOrContainsReferences<T>()) throw Unknown(typeof(T));
        for (; values.Length > 0; values = values[Math.Min(values.Length, 1 << 20)..]) // in pieces, because a span's bytes are counted by an int
            hash.AppendData(MemoryMarshal.AsBytes(values[..Math.Min(values.Length, 1 << 20)]));
        return this;
    }

    private static NotSupportedException Unknown(Type type) => new(
        $"is of the class {type.Name}, which does not list its numbers; override Numbers in it (docs/adding-a-primitive.md)");
}
