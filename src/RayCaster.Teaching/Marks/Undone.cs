namespace RayCaster.Teaching;

/// <summary>What a program that is not finished leaves out of its pictures.</summary>
[Flags]
public enum Undone
{
    /// <summary>Nothing: the program is finished.</summary>
    Nothing = 0,

    /// <summary>Planes are not drawn.</summary>
    Plane = 1,

    /// <summary>Spheres are not drawn.</summary>
    Sphere = 2,

    /// <summary>Boxes are not drawn.</summary>
    Aabb = 4,

    /// <summary>Circles are not drawn.</summary>
    Circle = 8,

    /// <summary>Triangles, those of meshes included, are not drawn.</summary>
    Triangle = 16,

    /// <summary>Colours do not fade with the distance.</summary>
    Attenuation = 32,

    /// <summary>zNear and zFar cut nothing.</summary>
    Clipping = 64,
}

/// <summary>What follows from an <see cref="Undone"/>.</summary>
internal static class UndoneParts
{
    private static readonly Mistake[] withoutAttenuation = [MistakeCatalog.Named("att-none")!];
    private static readonly Mistake[] withoutClipping = [MistakeCatalog.Named("no-znear")!, MistakeCatalog.Named("no-zfar")!];

    /// <summary>What is not drawn after each step of the lab, the last step first.</summary>
    public static readonly Undone[] InOrder = [.. Steps()];

    /// <summary>The words that a rubric has for them, in the order of the flags.</summary>
    public static readonly string[] Words = ["plane", "sphere", "aabb", "circle", "triangle", "attenuation", "clipping"];

    /// <summary>The flag of a word.</summary>
    public static Undone Named(string word) => (Undone)(1 << Array.IndexOf(Words, word));

    /// <summary>The words of all flags that are set.</summary>
    public static IEnumerable<string> InWords(this Undone undone) => Words.Where((_, i) => ((int)undone >> i & 1) != 0);

    /// <summary>A scene without the models that are not drawn.</summary>
    public static Scene Without(this Scene scene, Undone undone) =>
        (undone & ~(Undone.Attenuation | Undone.Clipping)) == 0 ? scene
        : scene with { Models = [.. scene.Models.Where(model => (undone & KindOf(model)) == 0)] };

    /// <summary>The steps that are left out, as deviations from the definition.</summary>
    public static IEnumerable<Mistake> Deviations(this Undone undone) =>
    [
        .. undone.HasFlag(Undone.Attenuation) ? withoutAttenuation : [],
        .. undone.HasFlag(Undone.Clipping) ? withoutClipping : [],
    ];

    /// <summary>All that programs may leave out of these scenes: every subset of their kinds of model, attenuation and clipping.</summary>
    public static IEnumerable<Undone> SubsetsFor(IEnumerable<Scene> scenes)
    {
        var all = Undone.Attenuation | Undone.Clipping;
        foreach (var scene in scenes)
            foreach (var model in scene.Models) all |= KindOf(model);
        for (var subset = Undone.Nothing; subset <= all; subset++)
            if ((subset & ~all) == 0) yield return subset;
    }

    private static IEnumerable<Undone> Steps()
    {
        var undone = Undone.Nothing;
        yield return undone;
        foreach (var part in (Undone[])
            [Undone.Triangle, Undone.Circle, Undone.Sphere, Undone.Aabb, Undone.Clipping, Undone.Attenuation, Undone.Plane])
            yield return undone |= part;
    }

    private static Undone KindOf(Model model) => model switch
    {
        Model<Plane> => Undone.Plane,
        Model<Sphere> => Undone.Sphere,
        Model<Aabb> => Undone.Aabb,
        Model<Circle> => Undone.Circle,
        Model<Triangle> or Mesh => Undone.Triangle,
        _ => Undone.Nothing,
    };
}
