namespace Lab;

/// <summary>Turns a pixel into a ray, and a hit into a colour.</summary>
public class Camera
{
    public Vector3 Position, Target, Up; // P, T, up

    public Vector3 W, U, V; // backwards, to the right, upwards; each of length 1

    public double h, w; // the size of the picture plane at distance 1; w is not W

    public int Height, Width; // in pixels
    public double ZNear = 0.01, ZFar = 100, Bias = 1e-6;

    public bool ClipsByDistance; // zNear and zFar are spheres around the camera, not planes across the view

    public double SampleOffset; // where in its pixel a ray passes: 0 at the lower left corner, 0.5 in the middle

    public Camera(Vector3 position, Vector3 target, Vector3 up, double fovY, int width, int height)
    {
        (Position, Target, Up, Height, Width) = (position, target, up, height, width);
        // BEGIN SOLUTION "Camera"
        // STUB Todo.Note("Camera");
        // STUB W = U = V = Vector3.Zero;
        W = -(Target - Position).Normalized;
        U = (Up % W).Normalized;
        V = W % U;
        h = 2 * Math.Tan(fovY / 2 * Math.PI / 180); // fovY is in degrees, Math.Tan takes radians
        w = h * Width / Height; // not h * (Width / Height): of two integers that is a whole number
        // END SOLUTION
    }

    /// <summary>d of the ray through a point of the picture: c pixels from its left edge, r pixels from its lower edge.</summary>
    public Vector3 Direction(double c, double r)
    {
        // BEGIN SOLUTION "Camera Pixel Translation"
        // STUB return Todo.Note("Camera Pixel Translation", Vector3.Zero);
        var ur = h * r / Height - h / 2;
        var uc = w * c / Width - w / 2;
        return (uc * U + ur * V - W).Normalized;
        // END SOLUTION
    }

    /// <summary>The ray of the pixel in column c from the left and row r from the bottom, both from 0.</summary>
    public Ray RayThrough(int c, int r)
    {
        var d = Direction(c + SampleOffset, r + SampleOffset);
        return new Ray(Position, d) { Bias = Bias, ZNear = ZNear, ZFar = ZFar, DepthPerT = ClipsByDistance ? 1 : -(d * W) };
    }

    /// <summary>The colour that a ray shows at its hit: the farther, the darker; black at 2 |T − P| and beyond.</summary>
    public Color Shade(Ray ray)
    {
        // BEGIN SOLUTION "Primitive Shading"
        // STUB return Todo.Note("Primitive Shading", ray.HitModel.Color);
        var attenuation = 1 - ray.HitParameter / (2 * (Target - Position)).Length;
        return Math.Max(0, attenuation) * ray.HitModel.Color;
        // END SOLUTION
    }
}
