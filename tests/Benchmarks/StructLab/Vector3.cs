namespace Lab;

/// <summary>The lab's Vector3 (src/RayCaster.Lab) as a struct.</summary>
public struct Vector3(double x, double y, double z)
{
    public double X = x, Y = y, Z = z;

    public static Vector3 Zero => new(0, 0, 0); // a new one each time, because its coordinates can be changed

    public static Vector3 operator +(Vector3 a, Vector3 b) =>
        new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Vector3 operator -(Vector3 a, Vector3 b) =>
        new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vector3 operator *(double b, Vector3 a) =>
        new(b * a.X, b * a.Y, b * a.Z); // the slide's fourth coordinate ", 0" is an error

    public static double operator *(Vector3 a, Vector3 b) => // dot product
        a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static Vector3 operator %(Vector3 a, Vector3 b) => // cross product
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    public double Length =>
        Math.Sqrt(this * this);

    public Vector3 Normalized => this / Length; // NaN for the zero vector, which has no direction

    public static Vector3 operator *(Vector3 a, double b) => b * a;

    public static Vector3 operator /(Vector3 a, double b) => new(a.X / b, a.Y / b, a.Z / b);

    public static Vector3 operator -(Vector3 a) => -1 * a;
}
