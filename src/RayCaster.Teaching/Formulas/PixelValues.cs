using System.Numerics;

namespace RayCaster.Teaching.Formulas;

/// <summary>The value of an expression in many pixels: an array, of the length of a <see cref="Vector{T}"/> where it is the same in all
/// of them; a vector has three.</summary>
internal readonly record struct PixelValues(double[] X, double[]? Y = null, double[]? Z = null)
{
    public static PixelValues From(double value) => new(Same(value));

    public static PixelValues From(Vector3 value) => new(Same(value.X), Same(value.Y), Same(value.Z));

    /// <summary>A number in one pixel.</summary>
    public double this[int pixel] => X[pixel < X.Length ? pixel : 0];

    /// <summary>A vector in one pixel.</summary>
    public Vector3 At(int pixel) => new(this[pixel], Y![pixel < Y.Length ? pixel : 0], Z![pixel < Z.Length ? pixel : 0]);

    public void Set(int pixel, Vector3 value) => (X[pixel], Y![pixel], Z![pixel]) = (value.X, value.Y, value.Z);

    /// <summary>The same in arrays of its own.</summary>
    public PixelValues Copy() => new([.. X], Y is null ? null : [.. Y], Z is null ? null : [.. Z]);

    private static double[] Same(double value)
    {
        var array = new double[Vector<double>.Count];
        Array.Fill(array, value);
        return array;
    }
}
