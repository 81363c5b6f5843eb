using System.Numerics;

namespace RayCaster.Teaching.Formulas;

/// <summary>Evaluates expressions in many pixels at once. Truth is 1 or 0.</summary>
/// <param name="pixels">How many pixels have values that are not the same in all of them: a multiple of <see cref="Vector{T}.Count"/>;
/// 0 if there are none.</param>
/// <remarks>Not for several threads: arrays that were given back are used again.</remarks>
internal sealed class PixelArithmetic(int pixels)
{
    private static readonly Step slides = FormulaBook.Slides.StylesOf(StepKind.Vectors)[0];

    /// <summary>What an operation takes beside the pixels, as so many pixels do.</summary>
    private const int WorkOfOperation = 150;

    private readonly List<double[]> pool = []; // the first ones are in use
    private bool isInSum;

    /// <summary>The functions of vectors.</summary>
    public Step Functions { get; set; } = slides;

    /// <summary>How many arrays are in use.</summary>
    public int Used { get; private set; }

    /// <summary>What has been done: the numbers that were computed, and something for each operation.</summary>
    public long Work { get; set; }

    /// <summary>The value of an expression. What was computed on the way to it is given back.</summary>
    /// <param name="frame">The values of names, by <see cref="Symbol.Place"/>; of a function's parameters in its body.</param>
    public PixelValues Evaluate(Expression e, PixelValues[] frame)
    {
        var used = Used;
        var value = Compute(e, frame);
        GiveBack(used, value.X, value.Y, value.Z);
        return value;
    }

    /// <summary>Computes a step's formulas, or takes their values from another frame if neither they nor what they read have changed.</summary>
    /// <param name="before">The step with which the other frame was computed; null for none.</param>
    /// <param name="changed">The names that have other values than in the other frame.</param>
    public void Define(Step step, PixelValues[] frame, Step? before, PixelValues[]? old, ref UInt128 changed)
    {
        var isSame = ReferenceEquals(step, before) && (step.Reads & changed) == 0;
        if (!isSame) Define(step, frame);
        foreach (var formula in step.Formulas)
        {
            if (isSame) frame[formula.Name.Place] = old![formula.Name.Place];
            changed = isSame ? changed & ~formula.Name.Bit : changed | formula.Name.Bit;
        }
    }

    /// <summary>Computes a step's formulas.</summary>
    public void Define(Step step, PixelValues[] frame)
    {
        foreach (var (name, expression, _) in step.Formulas) frame[name.Place] = Evaluate(expression, frame);
    }

    /// <summary>A frame with other values of some names.</summary>
    /// <param name="into">The array that holds it.</param>
    public static PixelValues[] FrameOf(PixelValues[] frame, PixelValues[] into, (Symbol Name, PixelValues Value)[] numbers)
    {
        frame.CopyTo(into, 0);
        foreach (var (symbol, value) in numbers) into[symbol.Place] = value;
        return into;
    }

    /// <summary>Gives back what was computed since so many arrays were in use.</summary>
    /// <param name="but">What is still needed, if it is among them.</param>
    public void GiveBack(int used, params ReadOnlySpan<double[]?> but)
    {
        var end = Used;
        Used = used;
        foreach (var array in but)
        {
            for (var i = end - 1; i >= Used; i--)
            {
                if (!ReferenceEquals(pool[i], array)) continue;
                (pool[i], pool[Used]) = (pool[Used], array);
                Used++;
                break;
            }
        }
    }

    private PixelValues Compute(Expression e, PixelValues[] frame)
    {
        switch (e.Operator)
        {
            case Operator.Number: return e.Constant;
            case Operator.Name: return frame[e.Symbol!.Place];
            case Operator.X: return new(Compute(e.Operands[0], frame).X);
            case Operator.Y: return new(Compute(e.Operands[0], frame).Y!);
            case Operator.Z: return new(Compute(e.Operands[0], frame).Z!);
            case Operator.Vector:
                return new(Compute(e.Operands[0], frame).X, Compute(e.Operands[1], frame).X, Compute(e.Operands[2], frame).X);
            case Operator.If:
                return Chosen(Compute(e.Operands[0], frame).X, Compute(e.Operands[1], frame), Compute(e.Operands[2], frame));
            case Operator.Call:
                var arguments = new PixelValues[e.Operands.Length];
                for (var i = 0; i < arguments.Length; i++) arguments[i] = Compute(e.Operands[i], frame);
                return Evaluate(Functions.Formulas[e.Function].Right, arguments);
            default:
                var a = Compute(e.Operands[0], frame);
                if (e.Operands.Length == 1)
                    return a.Y is null ? new(Map(e.Operator, a.X)) : new(Map(e.Operator, a.X), Map(e.Operator, a.Y), Map(e.Operator, a.Z!));
                var b = Compute(e.Operands[1], frame);
                if (e.Function >= 0 && !isInSum && Functions.Formulas[e.Function].Right != slides.Formulas[e.Function].Right)
                {
                    isInSum = true; // an edited sum may have a sum of vectors itself
                    var sum = Compute(Functions.Formulas[e.Function].Right, [a, b]);
                    isInSum = false;
                    return sum;
                }
                return a.Y is null && b.Y is null ? new(Zip(e.Operator, a.X, b.X))
                    : new(Zip(e.Operator, a.X, b.X), Zip(e.Operator, a.Y ?? a.X, b.Y ?? b.X), Zip(e.Operator, a.Z ?? a.X, b.Z ?? b.X));
        }
    }

    /// <summary>An array for a result; its content is undefined.</summary>
    public double[] New(int length)
    {
        Work += WorkOfOperation + length;
        if (length != pixels) return new double[length];
        if (Used == pool.Count) pool.Add(new double[pixels]);
        return pool[Used++];
    }

    public PixelValues NewVector(int length) => new(New(length), New(length), New(length));

    private PixelValues Chosen(double[] condition, PixelValues then, PixelValues otherwise)
    {
        return then.Y is null ? new(Of(then.X, otherwise.X)) : new(Of(then.X, otherwise.X), Of(then.Y, otherwise.Y!), Of(then.Z!, otherwise.Z!));

        double[] Of(double[] a, double[] b)
        {
            var r = New(Math.Max(condition.Length, Math.Max(a.Length, b.Length)));
            for (var i = 0; i < r.Length; i++) r[i] = At(condition, i) != 0 ? At(a, i) : At(b, i);
            return r;
        }

        static double At(double[] a, int i) => a[i < a.Length ? i : 0];
    }

    private double[] Map(Operator op, double[] a)
    {
        var r = New(a.Length);
        switch (op)
        {
            case Operator.Negate: for (var i = 0; i < r.Length; i++) r[i] = -a[i]; break;
            case Operator.Not: for (var i = 0; i < r.Length; i++) r[i] = a[i] == 0 ? 1 : 0; break;
            case Operator.Sqrt: for (var i = 0; i < r.Length; i++) r[i] = Math.Sqrt(a[i]); break;
            case Operator.Abs: for (var i = 0; i < r.Length; i++) r[i] = Math.Abs(a[i]); break;
            case Operator.Sin: for (var i = 0; i < r.Length; i++) r[i] = Math.Sin(a[i]); break;
            case Operator.Cos: for (var i = 0; i < r.Length; i++) r[i] = Math.Cos(a[i]); break;
            case Operator.Tan: for (var i = 0; i < r.Length; i++) r[i] = Math.Tan(a[i]); break;
            case Operator.Atan: for (var i = 0; i < r.Length; i++) r[i] = Math.Atan(a[i]); break;
            case Operator.Srgb:
                for (var i = 0; i < r.Length; i++) r[i] = a[i] <= 0.0031308 ? 12.92 * a[i] : 1.055 * Math.Pow(a[i], 1 / 2.4) - 0.055;
                break;
            case Operator.Truncate: for (var i = 0; i < r.Length; i++) r[i] = Math.Truncate(a[i]); break;
            case Operator.Cast: for (var i = 0; i < r.Length; i++) r[i] = double.IsFinite(a[i]) ? (byte)(long)a[i] : 0; break;
            default: throw new ArgumentOutOfRangeException(nameof(op), op, null);
        }
        return r;
    }

    private double[] Zip(Operator op, double[] a, double[] b)
    {
        var r = New(Math.Max(a.Length, b.Length));
        var size = Vector<double>.Count; // the length of what is the same in all pixels: it is read again and again
        var da = a.Length == size ? 0 : size;
        var db = b.Length == size ? 0 : size;
        int i = 0, j = 0, k = 0;
        switch (op)
        {
            case Operator.Add: for (; i < r.Length; i += size, j += da, k += db) (At(a, j) + At(b, k)).CopyTo(r, i); break;
            case Operator.Subtract: for (; i < r.Length; i += size, j += da, k += db) (At(a, j) - At(b, k)).CopyTo(r, i); break;
            case Operator.Multiply or Operator.And: for (; i < r.Length; i += size, j += da, k += db) (At(a, j) * At(b, k)).CopyTo(r, i); break;
            case Operator.Divide: for (; i < r.Length; i += size, j += da, k += db) (At(a, j) / At(b, k)).CopyTo(r, i); break;
            case Operator.Less: for (; i < r.Length; i += size, j += da, k += db) Less(At(a, j), At(b, k)).CopyTo(r, i); break;
            case Operator.Greater: for (; i < r.Length; i += size, j += da, k += db) Less(At(b, k), At(a, j)).CopyTo(r, i); break;
            case Operator.AtMost: for (; i < r.Length; i += size, j += da, k += db) AtMost(At(a, j), At(b, k)).CopyTo(r, i); break;
            case Operator.AtLeast: for (; i < r.Length; i += size, j += da, k += db) AtMost(At(b, k), At(a, j)).CopyTo(r, i); break;
            case Operator.Equal: for (; i < r.Length; i += size, j += da, k += db) Truth(Vector.Equals(At(a, j), At(b, k))).CopyTo(r, i); break;
            case Operator.Power: for (; i < r.Length; i++) r[i] = Math.Pow(a[da == 0 ? 0 : i], b[db == 0 ? 0 : i]); break;
            case Operator.Or: for (; i < r.Length; i += size, j += da, k += db) Vector.Max(At(a, j), At(b, k)).CopyTo(r, i); break;
            case Operator.Min: for (; i < r.Length; i += size, j += da, k += db) Min(At(a, j), At(b, k)).CopyTo(r, i); break;
            case Operator.Max: for (; i < r.Length; i += size, j += da, k += db) (-Min(-At(a, j), -At(b, k))).CopyTo(r, i); break;
            default: throw new ArgumentOutOfRangeException(nameof(op), op, null);
        }
        return r;

        static Vector<double> At(double[] a, int i) => new(a, i);
    }

    private static Vector<double> Less(Vector<double> a, Vector<double> b) => Truth(Vector.LessThan(a, b));

    private static Vector<double> AtMost(Vector<double> a, Vector<double> b) => Truth(Vector.LessThanOrEqual(a, b));

    private static Vector<double> Truth(Vector<long> mask) => Vector.ConditionalSelect(mask, Vector<double>.One, Vector<double>.Zero);

    /// <summary>
    /// The least. A ray in a face of a box gets 0 / 0 for that face and ±∞ for the other; the face belongs to the box, so the ray is in this slab
    /// from −∞ on. Any other NaN is ignored.
    /// </summary>
    private static Vector<double> Min(Vector<double> a, Vector<double> b)
    {
        var least = Vector.ConditionalSelect(Vector.LessThan(a, b), a, b);
        var number = Vector.ConditionalSelect(Vector.IsNaN(a), b, a);
        var ofNone = Vector.ConditionalSelect(Vector.IsInfinity(a) | Vector.IsInfinity(b), new(double.NegativeInfinity), number);
        return Vector.ConditionalSelect(Vector.IsNaN(a) | Vector.IsNaN(b), ofNone, least);
    }
}
