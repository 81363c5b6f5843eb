namespace RayCaster.Teaching;

/// <summary>
/// A drawing from the side, in the plane of a pixel's ray and the camera's V: sections of the shapes, the clip planes and the crossings.
/// Coordinates start at P: v along V, and u at right angles to V, in the direction of the ray.
/// </summary>
/// <param name="Direction">d.</param>
/// <param name="Near">The u of the near plane; null if zNear is a distance, whose section is a circle.</param>
/// <param name="Far">The u of the far plane; null if zFar is a distance.</param>
public sealed record RaySection(double[] Direction, double? Near, double? Far, SectionView View, IReadOnlyList<ModelSection> Models,
    IReadOnlyList<SectionCrossing> Crossings)
{
    private const int Around = 720, Ahead = 400;

    /// <summary>The section for an explanation.</summary>
    public static RaySection Of(PixelExplanation pixel)
    {
        var (camera, d) = (pixel.Scene.Camera, pixel.Ray.Direction);
        var v = camera.V;
        var across = d - d * v * v;
        var u = across.Length > 1e-9 ? across.Normalized : -1 * camera.W; // along V itself any direction will do
        var crossings = (from model in pixel.Models
                         from crossing in model.Crossings
                         where double.IsFinite(crossing.T)
                         select new SectionCrossing(model.Index, model.Name, crossing.T, [crossing.T * (d * u), crossing.T * (d * v)],
                             crossing.Outcome.Verdict(), crossing.Reason)).ToList();

        var shown = double.IsFinite(pixel.Ray.HitParameter) ? pixel.Ray.HitParameter : camera.Reach / 2;
        var length = crossings.Where(crossing => crossing.T > 0 && crossing.T <= 2 * shown).Select(crossing => crossing.T).Append(shown).Max();
        var fan = new Fan(camera.Position, u, v, Math.Atan2(d * v, d * u), camera.FovY * Math.PI / 180, 20 * length);
        var end = (U: length * (d * u), V: length * (d * v));
        var depth = -(camera.W * u);
        var isDepth = camera.Clip == Clip.Depth && depth > 0;
        return new([d * u, d * v], isDepth ? camera.ZNear / depth : null, isDepth ? camera.ZFar / depth : null,
            new(Math.Min(0, end.U) - 0.1 * length, Math.Max(0, end.U) + 0.2 * length,
                Math.Min(0, end.V) - 0.2 * length, Math.Max(0, end.V) + 0.2 * length),
            [.. pixel.Models.Select(model => fan.Cut(pixel.Scene.Models[model.Index], model))], crossings);
    }

    /// <summary>Casts rays from P in all directions of the plane. Their crossings with a shape, by its own formula, are its section.</summary>
    private sealed class Fan(Vector3 origin, Vector3 u, Vector3 v, double angle, double fovY, double farthest)
    {
        private readonly double[] angles =
        [
            .. Enumerable.Range(0, Around).Select(i => -Math.PI + 2 * Math.PI * i / Around)
                .Concat(Enumerable.Range(0, Ahead).Select(i => angle + fovY * ((i + 0.5) / Ahead - 0.5))).Order(), // finer near the ray
        ];

        public ModelSection Cut(Model model, ModelExplanation explanation)
        {
            var (r, g, b) = model.Color.ToBytes();
            var lines = model is Mesh mesh ? Cut(mesh) : Cut(model);
            return new(explanation.Index, explanation.Name, FormattableString.Invariant($"#{r:x2}{g:x2}{b:x2}"), lines);
        }

        private List<double[][]> Cut(Model model)
        {
            var (lines, near, far) = (new List<double[][]>(), new List<double[]>(), new List<double[]>());
            foreach (var angle in angles)
            {
                var (sin, cos) = Math.SinCos(angle);
                // a model in plain doubles and ifs has no formula to cut
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
            var (n, lines) = (u % v, new List<double[][]>());
            for (var i = 0; i < mesh.TriangleCount && lines.Count < ModelSection.MostLines; i++)
            {
                var (a, b, c) = (mesh[i].A - origin, mesh[i].B - origin, mesh[i].C - origin);
                var (da, db, dc) = (a * n, b * n, c * n);
                if (da > 0 == db > 0 && db > 0 == dc > 0) continue;
                var ends = new List<double[]>(2);
                foreach (var (p, q, dp, dq) in (ReadOnlySpan<(Vector3, Vector3, double, double)>)[(a, b, da, db), (b, c, db, dc), (c, a, dc, da)])
                {
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

/// <summary>The part of the plane to draw.</summary>
public sealed record SectionView(double Left, double Right, double Bottom, double Top);

/// <summary>The section of one model.</summary>
/// <param name="Color">Its colour as #rrggbb.</param>
/// <param name="Lines">Lines of points (u, v).</param>
public sealed record ModelSection(int Index, string Name, string Color, IReadOnlyList<double[][]> Lines)
{
    /// <summary>The most lines that are drawn of a mesh.</summary>
    public const int MostLines = 4000;
}

/// <summary>A crossing in the drawing.</summary>
/// <param name="Model">The model's place in the scene.</param>
/// <param name="At">Where it lies, (u, v).</param>
/// <param name="Verdict">shows, hidden, notNeeded, refused or missed.</param>
public sealed record SectionCrossing(int Model, string Name, double T, double[] At, string Verdict, string Reason);
