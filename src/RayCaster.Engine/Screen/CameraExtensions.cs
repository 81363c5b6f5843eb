namespace RayCaster.Engine;

/// <summary>Numbers of a camera for projections into the picture.</summary>
internal static class CameraExtensions
{
    extension(Camera camera)
    {
        /// <summary>How far from its pixel's lower left corner a ray passes, to the right and upwards, in pixels.</summary>
        public double SampleOffset => camera.Sample == PixelSample.Center ? 0.5 : 0;

        /// <summary>How far U, V and W are from right angles and from length 1. It is all rounding, but large where up is nearly the view direction.
        /// A ray then meets a point a little beside the pixel to which U and V project it.</summary>
        public double Skew
        {
            get
            {
                var (U, V, W) = (camera.U, camera.V, camera.W);
                return Math.Max(Math.Max(Math.Abs(U * W), Math.Abs(V * W)), Math.Max(Math.Abs(U * U - 1), Math.Abs(V * V - 1)));
            }
        }

        /// <summary>Whether projected points are so far from the rays that meet them that margins of 1e-12 of their distance are too
        /// small.</summary>
        public bool IsSkewed => camera.Skew > 1e-13;
    }
}
