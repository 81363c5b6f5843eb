namespace RayCaster.Teaching;

/// <summary>
/// What a scene is fit for as a test: which mistakes of the catalogue its picture cannot show, which it cannot tell apart, and which of its
/// pixels depend on the last bits. Several scenes are judged as a set: what one hides another may show.
/// </summary>
public sealed class SceneFitness
{
    /// <summary>As many pixels as must look otherwise for a mistake to be seen.</summary>
    public const int LeastPixels = 20;

    /// <summary>As many models as a scene may have for mistakes to be tried on it.</summary>
    public const int MostModels = Lab.MostModels;

    /// <summary>A larger picture is judged by a smaller one of the same shape.</summary>
    private const int MostPixels = 1_000_000;

    /// <summary>How many pixels of each picture tell most mistakes apart; the others need the whole picture.</summary>
    private const int Samples = 4096;

    private SceneFitness(IReadOnlyList<Scene> scenes, int? threads)
    {
        Scenes = [.. scenes.Select(Judged)];
        Reduced = !Scenes.SequenceEqual(scenes);
        scenes = Scenes;
        var known = MistakeCatalog.All.Where(mistake => scenes.All(scene => new Lab(scene, mistake).TrianglesTried <= Lab.MostTriangles)).ToArray();
        NotTried = [.. MistakeCatalog.All.Except(known)];
        var options = new ParallelOptions { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount };
        var views = scenes.Select(scene => new View(scene)).ToArray();
        foreach (var view in views) Parallel.For(0, known.Length, options, i => view.Look(known[i], IndexOf(known[i])));

        Hidden = [.. known.Where(mistake => !views.Any(view => view.Shows(IndexOf(mistake))))];
        WithinRounding = [.. Hidden.Where(mistake => views.Any(view => view.ShowsByALevel(IndexOf(mistake))))];
        Twins = Groups(views, [.. known.Except(Hidden)]);
        ShowsNothing = views.All(view => view.IsOfOneColor);
        FragilePixels = views.Sum(view => FragilePixelsOf(view.Scene, threads));
        PixelCount = scenes.Sum(scene => (long)scene.Camera.Width * scene.Camera.Height);
    }

    /// <summary>What was judged, with the sizes of picture that were.</summary>
    public IReadOnlyList<Scene> Scenes { get; }

    /// <summary>Whether a picture was too large and a smaller one was judged instead.</summary>
    public bool Reduced { get; }

    /// <summary>The mistakes that change fewer than <see cref="LeastPixels"/> pixels of each picture by more than rounding does.</summary>
    public IReadOnlyList<Mistake> Hidden { get; }

    /// <summary>Those of the hidden ones that do change pixels, by a level: a comparison shows them, the eye does not.</summary>
    public IReadOnlyList<Mistake> WithinRounding { get; }

    /// <summary>Those that take too long to try: a scene has too many triangles for them.</summary>
    public IReadOnlyList<Mistake> NotTried { get; }

    /// <summary>Mistakes that are seen, but give the same pictures, in groups.</summary>
    public IReadOnlyList<IReadOnlyList<Mistake>> Twins { get; }

    /// <summary>Whether every picture is of one colour.</summary>
    public bool ShowsNothing { get; }

    /// <summary>How many pixels show another model when a number of the camera is moved by its last bit.</summary>
    public int FragilePixels { get; }

    /// <summary>How many pixels the pictures have together.</summary>
    public long PixelCount { get; }

    /// <summary>Judges a set of scenes.</summary>
    /// <param name="scenes">At least one, each fit for <see cref="CanJudge"/>.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    public static SceneFitness Of(IReadOnlyList<Scene> scenes, int? threads = null) => new(scenes, threads);

    /// <summary>Whether a scene has so few models that mistakes can be tried on it.</summary>
    public static bool CanJudge(Scene scene) => scene.Models.Count <= MostModels;

    private static Scene Judged(Scene scene)
    {
        var camera = scene.Camera;
        var most = Math.Clamp(MostPixels * 50L / Math.Max(1, scene.Models.Count), 2500, MostPixels); // the time stays
        var shrink = Math.Sqrt((double)camera.Width * camera.Height / most);
        if (shrink <= 1) return scene;
        return scene with { Camera = camera.WithSize(Math.Max(1, (int)(camera.Width / shrink)), Math.Max(1, (int)(camera.Height / shrink))) };
    }

    private static int IndexOf(Mistake mistake)
    {
        for (var i = 0; ; i++)
            if (MistakeCatalog.All[i] == mistake) return i;
    }

    /// <summary>The groups of mistakes that no picture tells apart.</summary>
    private static List<IReadOnlyList<Mistake>> Groups(View[] views, List<Mistake> seen)
    {
        var groups = new List<IReadOnlyList<Mistake>>();
        while (seen is [var first, ..])
        {
            Mistake[] group = [.. seen.Where(other => other == first || views.All(view => view.AreAlike(IndexOf(first), IndexOf(other))))];
            seen.RemoveAll(group.Contains);
            if (group.Length > 1) groups.Add(group);
        }
        return groups;
    }

    /// <summary>A scene's picture with each mistake, as far as it is needed.</summary>
    private sealed class View(Scene scene)
    {
        private readonly int count = scene.Camera.Width * scene.Camera.Height;
        private readonly GoldenSteps places = new(scene.Camera.Width * scene.Camera.Height); // of samples
        private readonly Picture right = Renderer.Render(scene);
        private readonly byte[][] samples = new byte[MistakeCatalog.All.Count][];
        private readonly int[] changed = new int[MistakeCatalog.All.Count];   // pixels beyond rounding, at least as many as matter
        private readonly bool[] byALevel = new bool[MistakeCatalog.All.Count];

        public Scene Scene => scene;

        public bool IsOfOneColor => right.IsOneColor;

        public bool Shows(int mistake) => changed[mistake] >= LeastPixels;

        public bool ShowsByALevel(int mistake) => byALevel[mistake];

        /// <summary>Draws samples of the picture, and all of it where they do not show the mistake.</summary>
        public void Look(Mistake mistake, int index)
        {
            var lab = new Lab(scene, mistake);
            var most = lab.TrianglesTried == 0 ? Samples : Math.Min(Samples, Evidence.MostTests / lab.TrianglesTried);
            var pixels = new byte[3 * Math.Min(most, count)];
            for (var k = 0; k < pixels.Length / 3; k++) Put(lab, places[k], pixels, 3 * k);
            samples[index] = pixels;
            changed[index] = SizeOf(lab) != (right.Width, right.Height) ? LeastPixels : CountSamples(pixels);
            // Triangles that reach out of themselves change large parts of a picture: if the samples show nothing, nothing is there.
            if (Shows(index) || !mistake.Touches(scene) || lab.TrianglesTried > 0) return;
            changed[index] = 0;
            var pixel = new byte[3];
            for (var i = 0; i < count && !Shows(index); i++)
            {
                Put(lab, i, pixel, 0);
                var difference = Difference(pixel, 0, right.Rgb, 3 * i);
                if (difference > Evidence.Tolerance) changed[index]++;
                byALevel[index] |= difference > 0;
            }
        }

        /// <summary>Whether the pictures of two mistakes differ in fewer pixels than matter.</summary>
        public bool AreAlike(int a, int b)
        {
            var (one, other) = (new Lab(scene, MistakeCatalog.All[a]), new Lab(scene, MistakeCatalog.All[b]));
            if (SizeOf(one) != SizeOf(other)) return false;
            var different = 0;
            for (var k = 0; k < Math.Min(samples[a].Length, samples[b].Length) && different < LeastPixels; k += 3)
                if (Difference(samples[a], k, samples[b], k) > Evidence.Tolerance) different++;
            if (different >= LeastPixels) return false;
            if (one.TrianglesTried + other.TrianglesTried > 0) return different == 0;
            different = 0;
            var (p, q) = (new byte[3], new byte[3]);
            for (var i = 0; i < count && different < LeastPixels; i++)
            {
                Put(one, i, p, 0);
                Put(other, i, q, 0);
                if (Difference(p, 0, q, 0) > Evidence.Tolerance) different++;
            }
            return different < LeastPixels;
        }

        private int CountSamples(byte[] pixels)
        {
            var different = 0;
            for (var k = 0; k < pixels.Length / 3; k++)
                if (Difference(pixels, 3 * k, right.Rgb, 3 * places[k]) > Evidence.Tolerance) different++;
            return different;
        }

        private static (int, int) SizeOf(Lab lab) => (lab.Width, lab.Height);

        private static void Put(Lab lab, int i, byte[] pixels, int at)
        {
            var (y, x) = Math.DivRem(i, lab.Width);
            (pixels[at], pixels[at + 1], pixels[at + 2]) = lab[x, y];
        }

        private static int Difference(byte[] a, int i, byte[] b, int j) =>
            PictureDifference.Levels((a[i], a[i + 1], a[i + 2]), (b[j], b[j + 1], b[j + 2]));
    }

    /// <summary>Moves each number of the camera by its last bit, up and down, and counts the pixels that ever show another model.</summary>
    private static int FragilePixelsOf(Scene scene, int? threads)
    {
        var right = new Renderer(scene, threads).CastHits();
        var fragile = new bool[right.Model.Length];
        foreach (var camera in Nudged(scene.Camera))
        {
            var hits = new Renderer(scene with { Camera = camera }, threads).CastHits();
            for (var i = 0; i < fragile.Length; i++) fragile[i] |= hits.Model[i] != right.Model[i];
        }
        return fragile.Count(pixel => pixel);
    }

    private static IEnumerable<Camera> Nudged(Camera camera)
    {
        foreach (var nudge in (Func<double, double>[])[Math.BitIncrement, Math.BitDecrement])
        {
            foreach (var P in Nudged(camera.Position, nudge)) yield return With(P, camera.Target, camera.Up, camera.FovY);
            foreach (var T in Nudged(camera.Target, nudge)) yield return With(camera.Position, T, camera.Up, camera.FovY);
            foreach (var up in Nudged(camera.Up, nudge)) yield return With(camera.Position, camera.Target, up, camera.FovY);
            yield return With(camera.Position, camera.Target, camera.Up, nudge(camera.FovY));
        }

        Camera With(Vector3 P, Vector3 T, Vector3 up, double fovY) => new(
            P, T, up, fovY, camera.Width, camera.Height, camera.ZNear, camera.ZFar, camera.Bias, camera.Clip, camera.Sample);
    }

    private static Vector3[] Nudged(Vector3 v, Func<double, double> nudge) =>
        [v with { X = nudge(v.X) }, v with { Y = nudge(v.Y) }, v with { Z = nudge(v.Z) }];
}
