namespace Lab;

/// <summary>A point or a direction. A class, as on the slides: after <c>Q = P</c> both name one object, and <c>P.X = 3</c> changes Q too.</summary>
public class Vector3(double x, double y, double z)
{
    public double X = x, Y = y, Z = z;

    public static Vector3 Zero => new(0, 0, 0); // a new one each time, because its coordinates can be changed

    public static Vector3 operator +(Vector3 a, Vector3 b)
    {
        // BEGIN SOLUTION "IDE & Vectors"
        // STUB return Todo.Note("IDE & Vectors", Zero);
        return new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);
        // END SOLUTION
    }

    public static Vector3 operator -(Vector3 a, Vector3 b)
    {
        // BEGIN SOLUTION "IDE & Vectors"
        // STUB return Todo.Note("IDE & Vectors", Zero);
        return new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);
        // END SOLUTION
    }

    public static Vector3 operator *(double b, Vector3 a) // b a, as on the slide
    {
        // BEGIN SOLUTION "IDE & Vectors"
        // STUB return Todo.Note("IDE & Vectors", Zero);
        return new(b * a.X, b * a.Y, b * a.Z); // the slide's fourth coordinate ", 0" is an error
        // END SOLUTION
    }

    public static double operator *(Vector3 a, Vector3 b) // dot product
    {
        // BEGIN SOLUTION "IDE & Vectors"
        // STUB return Todo.Note("IDE & Vectors", 0);
        return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
        // END SOLUTION
    }

    public static Vector3 operator %(Vector3 a, Vector3 b) // cross product
    {
        // BEGIN SOLUTION "IDE & Vectors"
        // STUB return Todo.Note("IDE & Vectors", Zero);
        return new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
        // END SOLUTION
    }

    public double Length
    {
        get
        {
            // BEGIN SOLUTION "IDE & Vectors"
            // STUB return Todo.Note("IDE & Vectors", 0);
            return Math.Sqrt(this * this);
            // END SOLUTION
        }
    }

    public Vector3 Normalized => this / Length; // NaN for the zero vector, which has no direction

    public static Vector3 operator *(Vector3 a, double b) => b * a;

    public static Vector3 operator /(Vector3 a, double b) => new(a.X / b, a.Y / b, a.Z / b);

    public static Vector3 operator -(Vector3 a) => -1 * a;
}
