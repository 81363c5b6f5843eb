namespace RayCaster.Teaching.Diagnosis;

/// <summary>A number that a scene gives, which may be another one in a picture: a scene is copied by hand into a program.</summary>
/// <param name="Part">The place of the shape that it belongs to; −1 for the camera.</param>
/// <param name="Value">A number, or a vector of which one component may be another.</param>
/// <param name="Axis">0 to 2; −1 for a number.</param>
/// <param name="Of">Whose number it is, in words.</param>
internal sealed record GivenNumber(int Part, Symbol Name, PixelValues Value, int Axis, string Of)
{
    /// <summary>A model of which a number is another one shows, or should show, at least this share of the wrong pixels.</summary>
    private const double Own = 0.3;

    /// <summary>How many numbers get a search for the best value, and how many steps it takes.</summary>
    private const int MaxSearched = 6, Steps = 20;

    /// <summary>What is tried first: differences as shares of the camera's distance, logarithms of ratios.</summary>
    private static readonly double[] shares = [0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6], ratios = [0.07, 0.15, 0.25, 0.35, 0.5, 0.7, 1, 1.5, 2, 3];

    private double Right => Axis < 0 ? Value[0] : ((double[])[Value.X[0], Value.Y![0], Value.Z![0]])[Axis];

    /// <summary>The number that explains a picture best: how far it is from explaining it, and a sentence on it.</summary>
    public static (Residual Residual, string Sentence) Find(Scene scene, SceneDifference byModels, PictureSample sample, int? threads)
    {
        var size = (scene.Camera.Target - scene.Camera.Position).Length;
        GivenNumber[] all = [.. OfCamera(), .. OfModels(scene, byModels, sample)];
        var found = new (Residual Residual, double Value)[all.Length];
        var options = new ParallelOptions { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount };
        Parallel.For(0, all.Length, options, i => found[i] = all[i].Tries(size).Select(value =>
            (all[i].ResidualAt(value, sample, 0.03), value)).Min());
        int[] best = [.. Enumerable.Range(0, all.Length).OrderBy(i => found[i].Residual).Take(MaxSearched)];
        Parallel.ForEach(best, options, i => found[i] = all[i].Closest(found[i].Value, sample));
        var first = best.MinBy(i => found[i].Residual);
        var (number, value) = (all[first], found[first].Value);
        if (sample.Lost(FormulaProgram.Slides, number.With(value)).Any()) // it shows what that loses
            return (new(sample.PixelCount, sample.PixelCount), "");
        var axis = number.Axis < 0 ? "" : $"{"xyz"[number.Axis]} of ";
        return (found[first].Residual,
            $"All is right if {axis}{number.Name.Text}{number.Of} is about {Short(value)}; the scene says {Short(number.Right)}.");

        IEnumerable<GivenNumber> OfCamera() => ((string[])["P", "T", "fovY", "zNear", "zFar"]).Select(Symbol.From)
            .SelectMany(name => From(-1, name, FormulaEvaluator.GivensOf(scene.Camera)[name.Place], ""));
    }

    private static IEnumerable<GivenNumber> OfModels(Scene scene, SceneDifference byModels, PictureSample sample)
    {
        var parts = scene.Models.Index().SelectMany(model => ShapePart.From(model.Item).Select(part =>
            (Model: model.Index, part.Numbers))).ToArray();
        return from model in byModels.Models
               where model.Model >= 0 && scene.Models[model.Model] is not Mesh
               let shown = byModels.Models.Sum(other => other.Shows.Where(shown => shown.Model == model.Model).Sum(shown => shown.Pixels))
               where model.Wrong + shown >= Own * sample.WrongCount
               from part in parts.Index()
               where part.Item.Model == model.Model
               from number in part.Item.Numbers
               from own in From(part.Index, number.Name, number.Value, $" of {model.Name}")
               select own;
    }

    private static IEnumerable<GivenNumber> From(int part, Symbol name, PixelValues value, string of) =>
        (value.Y is null ? [-1] : (int[])[0, 1, 2]).Select(axis => new GivenNumber(part, name, value, axis, of));

    /// <summary>The scene's number replaced.</summary>
    private (int Part, Symbol Name, PixelValues Value) With(double other)
    {
        if (Axis < 0) return (Part, Name, PixelValues.From(other));
        double[] all = [Value.X[0], Value.Y![0], Value.Z![0]];
        all[Axis] = other;
        return (Part, Name, PixelValues.From(new Vector3(all[0], all[1], all[2])));
    }

    private IEnumerable<double> Tries(double size) => Axis < 0 ? ratios.SelectMany(x => (double[])[Right * Math.Pow(2, x), Right * Math.Pow(2, -x)])
        : shares.SelectMany(share => (double[])[Right + share * size, Right - share * size]);

    /// <summary>Steps to either side of a value while that is better; otherwise halves the step.</summary>
    private (Residual, double) Closest(double value, PictureSample sample)
    {
        var best = ResidualAt(value, sample, 0.2);
        var step = Math.Abs(value - Right) / 3;
        for (var k = 0; k < Steps; k++)
        {
            var less = ResidualAt(value - step, sample, 0.2);
            var more = ResidualAt(value + step, sample, 0.2);
            var isLess = less.CompareTo(more) < 0;
            if ((isLess ? less : more).CompareTo(best) < 0) (best, value) = isLess ? (less, value - step) : (more, value + step);
            else step /= 2;
        }
        return (ResidualAt(value, sample, 1), value);
    }

    private Residual ResidualAt(double value, PictureSample sample, double share) => sample.Residual(FormulaProgram.Slides, With(value), share);

    /// <summary>Three digits.</summary>
    private static string Short(double x) =>
        x.ToString(Math.Abs(x) >= 100 ? "0" : Math.Abs(x) >= 10 ? "0.#" : "0.##", CultureInfo.InvariantCulture);
}
