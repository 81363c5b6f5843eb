namespace Lab;

/// <summary>X(t) = P + t d, and the nearest hit so far.</summary>
public class Ray(Vector3 origin, Vector3 direction)
{
    public Vector3 Origin = origin; // P

    public Vector3 Direction = direction; // d, of length 1, so that t is a distance

    public double HitParameter = double.PositiveInfinity; // t of the nearest hit; infinite before the first

    public Model HitModel; // the model hit there; null for none

    // z = t DepthPerT is the depth in front of the camera, which zNear and zFar limit: DepthPerT is the cosine between the ray and the view.
    // A ray made without a camera is not clipped.
    public double Bias, ZNear, ZFar = double.MaxValue, DepthPerT = 1;

    public Vector3 At(double t)
    {
        // BEGIN SOLUTION "Ray"
        // STUB return Todo.Note("Ray", Vector3.Zero);
        return Origin + t * Direction;
        // END SOLUTION
    }

    /// <summary>
    /// Keeps the hit of a model at t if t counts and is nearer than the nearest so far. Of two at the same t the first stays.
    /// </summary>
    public virtual void Hit(double t, Model model) // virtual: tests watch with which t it is called
    {
        // BEGIN SOLUTION "Ray"
        if (!Counts(t) || t >= HitParameter) return;
        HitParameter = t;
        HitModel = model;
        // END SOLUTION
    }

    /// <summary>Whether an intersection at t is to be seen. No comparison with NaN holds, so NaN never counts.</summary>
    public bool Counts(double t)
    {
        // BEGIN SOLUTION "Bias"
        // STUB Todo.Note("Bias");
        // STUB var isAhead = t > 0;
        var isAhead = Bias == 0 ? t >= 0 : t > Bias;
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
