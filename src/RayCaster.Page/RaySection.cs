namespace RayCaster.Page;

/// <summary>
/// A drawing from the side, in the plane of a pixel's ray and the camera's V: sections of the shapes, the clip planes and the crossings.
/// Coordinates start at P: v along V, and u at right angles to V, in the direction of the ray.
/// </summary>
internal static class RaySection
{
    private const int Around = 720, Ahead = 400;

    private const int MaxLines = 4000;

    public static RayDrawing Create(PixelExplanation pixel)
    {
        var camera = pixel.Scene.Camera;
        var d = pixel.Ray.Direction;
        var v = camera.V;
        var across = d - d * v * v;
        var u = across.Length > 1e-9 ? across.Normalized : -1 * camera.W; // along V itself any direction will do
        var shown = double.IsFinite(pixel.Hit.T) ? pixel.Hit.T : camera.FadeDistance / 2;
        var length = pixel.Models.SelectMany(model => model.Crossings).Select(crossing => crossing.T)
            .Where(t => t > 0 && t <= 2 * shown).Append(shown).Max();
        var (endU, endV) = (length * (d * u), length * (d * v));
        var fan = new Fan(camera.Position, u, v, Math.Atan2(d * v, d * u), camera.FovY * Math.PI / 180, 20 * length);
        var depth = -(camera.W * u);
        var isDepth = camera.Clip == ClipMode.Depth && depth > 0;
        return new([d * u, d * v], isDepth ? camera.ZNear / depth : null, isDepth ? camera.ZFar / depth : null,
            new(Left: Math.Min(0, endU) - 0.1 * length,
                Right: Math.Max(0, endU) + 0.2 * length,
                Bottom: Math.Min(0, endV) - 0.2 * length,
                Top: Math.Max(0, endV) + 0.2 * length),
            pixel.Models.Select(model =>
                new DrawnModel(model.Name, Messages.Hex(model.Result.Model.Color.ToBytes()), fan.Cut(model.Result.Model))),
            pixel.Models.SelectMany(model => model.Crossings.Where(crossing => double.IsFinite(crossing.T)).Select(crossing => new DrawnCrossing(
                [crossing.T * (d * u), crossing.T * (d * v)],
                crossing.Outcome == Outcome.Shows,
                $"t = {Digits.Format(crossing.T)}",
                $"{model.Name}: t = {Digits.Format(crossing.T)}, {crossing.Reason}"))));
    }

    /// <summary>Casts rays from P in all directions of the plane. Their crossings with a shape, by its own formula, are its section.</summary>
    private sealed class Fan(Vector3 origin, Vector3 u, Vector3 v, double angle, double fovY, double farthest)
    {
        private readonly double[] angles =
        [
            .. Enumerable.Range(0, Around).Select(i => -Math.PI + 2 * Math.PI * i / Around)
                .Concat(Enumerable.Range(0, Ahead).Select(i => angle + fovY * ((i + 0.5) / Ahead - 0.5))).Order(), // finer near the ray
        ];

        public List<double[][]> Cut(Model model)
        {
            if (model is Mesh mesh) return Cut(mesh);
            var lines = new List<double[][]>();
            var near = new List<double[]>();
            var far = new List<double[]>();
            foreach (var angle in angles)
            {
                var (sin, cos) = Math.SinCos(angle);
                // a scalar shape has no formula to cut
                if (model.Intersect(new Ray<Scalar>(origin, cos * u + sin * v)) is not { } crossings) break;
                double a = crossings.Near, b = crossings.Far;
                if (!IsDrawn(a) && !IsDrawn(b)) End();
                if (IsDrawn(a)) near.Add([a * cos, a * sin]);
                if (IsDrawn(b)) far.Add([b * cos, b * sin]);
            }
            End();
            return lines;

            // Seen from outside, the far side leads back to the start of the near side.
            void End()
            {
                if (near.Count > 0 && near.Count == far.Count) lines.Add([.. near, .. Enumerable.Reverse(far), near[0]]);
                else
                {
                    if (near.Count > 1) lines.Add([.. near]);
                    if (far.Count > 1) lines.Add([.. far]);
                }
                near.Clear();
                far.Clear();
            }
        }

        private bool IsDrawn(double t) => t > 0 && t < farthest;

        /// <summary>A mesh may have a million triangles, so the plane cuts each triangle directly.</summary>
        private List<double[][]> Cut(Mesh mesh)
        {
            var n = u % v;
            var lines = new List<double[][]>();
            for (var i = 0; i < mesh.TriangleCount && lines.Count < MaxLines; i++)
            {
                var (a, b, c) = (mesh[i].A - origin, mesh[i].B - origin, mesh[i].C - origin);
                var ends = new List<double[]>();
                foreach (var (p, q) in (ReadOnlySpan<(Vector3, Vector3)>)[(a, b), (b, c), (c, a)])
                {
                    var (dp, dq) = (p * n, q * n);
                    if (dp > 0 == dq > 0) continue;
                    var x = p + dp / (dp - dq) * (q - p);
                    ends.Add([x * u, x * v]);
                }
                if (ends.Count == 2) lines.Add([.. ends]);
            }
            return lines;
        }
    }
}
