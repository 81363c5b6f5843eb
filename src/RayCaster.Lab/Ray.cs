namespace Lab;

/// <summary>X(t) = P + t d, and the nearest hit so far.</summary>
/// <remarks>A crossing is a t of a model's formula. It counts if it lies beyond the bias and between zNear and zFar. The hit is the nearest that
/// counts.</remarks>
public class Ray(Vector3 origin, Vector3 direction)
{
    public Vector3 Origin = origin; // P

    public Vector3 Direction = direction; // d, of length 1, so that t is a distance

    public double HitParameter = double.PositiveInfinity; // t of the nearest hit; infinite before the first

    public Model HitModel; // the model hit there; null for none

    // zNear and zFar limit z = t DepthPerT. If the scene clips by depth, DepthPerT is −d·W: the cosine of the angle between the ray and the view
    // (W is in Camera.cs). If it clips by distance, DepthPerT is 1, so z = t. A ray that no camera makes, as in tests, is not clipped.
    public double Bias, ZNear, ZFar = double.MaxValue, DepthPerT = 1;

    public Vector3 At(double t)
    {
        // BEGIN SOLUTION "Ray"
        // STUB return Todo.Note("Ray", Vector3.Zero);
        return Origin + t * Direction;
        // END SOLUTION
    }

    /// <summary>
    /// Takes a crossing of a model: it is the hit if it counts and is nearer than the hit so far. Of two at the same t the first stays.
    /// </summary>
    public virtual void Hit(double t, Model model) // virtual: tests watch with which t it is called
    {
        // BEGIN SOLUTION "Ray"
        if (!Counts(t) || t >= HitParameter) return;
        HitParameter = t;
        HitModel = model;
        // END SOLUTION
    }

    /// <summary>Whether the crossing at t can be seen. Every comparison with NaN is false, so NaN, the root of a
    /// negative number, never counts.</summary>
    public bool Counts(double t)
    {
        // BEGIN SOLUTION "Bias"
        // STUB Todo.Note("Bias");
        // STUB var isAhead = t > 0;
        var isAhead = Bias == 0 ? t >= 0 : t > Bias; // scenes/bias.json shows why t = 0 counts with bias 0
        // END SOLUTION

        // BEGIN SOLUTION "zNear & zFar"
        // STUB Todo.Note("zNear & zFar");
        // STUB var isBetween = true;
        var z = t * DepthPerT;
        var isBetween = ZNear <= z && z <= ZFar;
        // END SOLUTION

        return isAhead && isBetween;
    }
}
