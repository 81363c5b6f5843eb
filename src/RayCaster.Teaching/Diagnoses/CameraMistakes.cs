namespace RayCaster.Teaching;

/// <summary>Between a pixel and its ray.</summary>
internal static class CameraMistakes
{
    public static Mistake[] All =>
    [
        new("w-sign", Concerns.Camera, Slides.Camera, "W = +(T − P) normalised, so that the camera looks backwards",
            lab => lab.AxisW.Becomes(W => (p, t) => -W(p, t)))
        {
            Hint = new("The picture shows what is behind the camera, or nothing.",
                "Which way does W point: to the target, or away from it?",
                "W = −(T − P) normalised: it points backwards, and d has −W in it."),
        },
        new Mistake("dir-plus-w", Concerns.Camera, Slides.RayThroughPixel, "d = uc U + ur V + W",
            lab => lab.Towards.Becomes(towards => (uc, ur) => -towards(-uc, -ur)))
        {
            Hint = new("Nothing before the camera is in the picture.",
                "W points backwards. With which sign does it go into d?",
                "d = (uc U + ur V − W) normalised."),
        }
        .Or("d = uc U + ur V + W, and the depth is measured along +W, too",
            lab =>
            {
                lab.AxisW.Becomes(W => (p, t) => -W(p, t)); // turns U about, but not V
                lab.Towards.Becomes(towards => (uc, ur) => towards(-uc, ur));
            }),
        new("u-cross", Concerns.Camera, Slides.Camera, "U = W × up; V = W × U turns with it",
            lab => lab.AxisU.Becomes(U => (up, w) => -U(up, w)))
        {
            Hint = new("The picture is turned by 180 degrees.",
                "a × b = −(b × a). In which order does the slide have up and W?",
                "U = (up × W) normalised."),
        },
        new("v-cross", Concerns.Camera, Slides.Camera, "V = U × W, so that V points down",
            lab => lab.AxisV.Becomes(V => (w, u) => -V(w, u)))
        {
            Hint = new("The picture is upside down, and a row off.",
                "Does V point up? Try W and U of a level camera by hand.",
                "V = W × U."),
        },
        new("u-only", Concerns.Camera, Slides.Camera, "U points to the left while V is right",
            lab => lab.Towards.Becomes(towards => (uc, ur) => towards(-uc, ur)))
        {
            Hint = new("The picture is mirrored left to right, and a column off.",
                "Look along −W, with V upwards: on which side is U?",
                "U = (up × W) normalised, V = W × U, and uc is multiplied by U as it is."),
        },
        new("rad", Concerns.Camera, Slides.Camera, "degrees into Math.Tan, which takes radians",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI)))
        {
            Hint = new("Everything has a wrong size, and may be turned by 180 degrees.",
                "In which unit is fovY, and in which unit does Math.Tan take its angle?",
                "h = 2 · Math.Tan(fovY · Math.PI / 180 / 2)."),
        },
        new("nohalf", Concerns.Camera, Slides.Camera, "h = 2 tan(fovY): the half of the angle is missing",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY)))
        {
            Hint = new("Everything is too small: the angle of view is too wide.",
                "The right-angled triangle from the camera to the upper edge: which part of fovY is its angle?",
                "h = 2 tan(fovY / 2)."),
        },
        new("no2", Concerns.Camera, Slides.Camera, "h = tan(fovY / 2): half of the plane's height",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) / 2))
        {
            Hint = new("Everything is twice as large as it should be.",
                "tan(fovY / 2) reaches from the axis to the upper edge. How far is it from edge to edge?",
                "h = 2 tan(fovY / 2)."),
        },
        new("aspect-inv", Concerns.Camera, Slides.Camera, "w = h · height / width",
            lab => lab.PlaneWidth.Becomes(w => h => h * h / w(h)))
        {
            Hint = new("Spheres are ellipses, far too long along the picture's longer side.",
                "Wide pictures need a wide plane. Which is larger in yours, w or h?",
                "w = h · width / height."),
        },
        new("aspect-none", Concerns.Camera, Slides.Camera, "w = h, whatever the picture's shape",
            lab => lab.PlaneWidth.Becomes(_ => h => h))
        {
            Rewrites = true,
            Hint = new("Spheres are ellipses, too long along the picture's longer side.",
                "Is a pixel of the plane a square?",
                "w = h · width / height."),
        },
        new Mistake("aspect-int", Concerns.Camera, Slides.Camera, "w = h · (width / height), divided in integers",
            lab => lab.PlaneWidth.Becomes(_ => h => h * (lab.Camera.Width / lab.Camera.Height)))
        {
            Rewrites = true,
            Hint = new("Spheres are ellipses; a picture that is higher than wide has only stripes.",
                "What is 320 / 200 in C#, where both are int?",
                "w = h · width / height, from left to right: h is a double, so no integers are divided."),
        }
        .Or("w = h · (height / width), divided in integers",
            lab => lab.PlaneWidth.Becomes(_ => h => h * (lab.Camera.Height / lab.Camera.Width))),
        new("fov-horiz", Concerns.Camera, Slides.Camera, "fovY taken from the left edge to the right one",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * lab.Camera.Height / lab.Camera.Width))
        {
            Hint = new("The whole picture is zoomed, with the right proportions.",
                "The Y in fovY: which two edges are that angle apart?",
                "h = 2 tan(fovY / 2) is the height; the width follows, w = h · width / height."),
        },
        new("pix-int", Concerns.Camera, Slides.RayThroughPixel, "w · (c / width), divided in integers: always 0",
            lab =>
            {
                lab.Uc.Becomes(uc => c => uc(lab.Camera.Width * Math.Floor(c / lab.Camera.Width)));
                lab.Ur.Becomes(ur => r => ur(lab.Camera.Height * Math.Floor(r / lab.Camera.Height)));
            })
        {
            Hint = new("The picture has one colour: every ray is the same.",
                "What is c / width in C#, where both are int?",
                "uc = w · c / width − w / 2, from left to right: w is a double, so no integers are divided."),
        },
        new("no-center", Concerns.Camera, Slides.RayThroughPixel, "uc and ur without − w / 2 and − h / 2",
            lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c) - uc(0));
                lab.Ur.Becomes(ur => r => ur(r) - ur(0));
            })
        {
            Hint = new("What should be in the middle is at the lower left corner.",
                "Which pixel has uc = 0 and ur = 0?",
                "uc = w c / width − w / 2, ur = h r / height − h / 2."),
        },
        new("center", Concerns.Camera, Slides.RayThroughPixel,
            "the ray passes the pixel's centre where its corner is meant (its corner where the centre is meant)",
            lab => lab.Sample.Becomes(sample =>
            {
                var half = lab.Camera.Sample == Sample.Corner ? 0.5 : -0.5;
                return (c, r) => sample(c + half, r + half);
            }))
        {
            Hint = new("Only outlines differ: everything is half a pixel off.",
                "Where in its pixel does the scene's \"sample\" want the ray?",
                "For corners uc = w c / width − w / 2; for centres c + 0.5 and r + 0.5 take the places of c and r."),
        },
        new("wm1", Concerns.Camera, Slides.RayThroughPixel, "c / (width − 1) and r / (height − 1)",
            lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c * lab.Camera.Width / (lab.Camera.Width - 1)));
                lab.Ur.Becomes(ur => r => ur(r * lab.Camera.Height / (lab.Camera.Height - 1)));
            })
        {
            Hint = new("Only outlines differ: not at the lower left, and ever more towards the right and the top, up to a pixel.",
                "By what does the slide divide c?",
                "uc = w c / width − w / 2, ur = h r / height − h / 2."),
        },
        new("u-unnorm", Concerns.Camera, Slides.Camera, "U = up × W, not normalised",
            lab => lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w)))
        {
            Hint = new("The more the camera looks up or down, the more the picture is zoomed in.",
                "How long is up × W where they are not perpendicular?",
                "U = (up × W) normalised."),
        },
        new("w-unnorm", Concerns.Camera, Slides.Camera, "W = −(T − P), not normalised",
            lab => lab.AxisW.Becomes(W => (p, t) => lab.Length.Do(t - p) * W(p, t)))
        {
            Hint = new("Everything is drawn out sideways, the more the farther the target is, or zFar has cut all of it away.",
                "The plane lies at distance |W| before the camera. How long is your W?",
                "W = −(T − P) normalised."),
        },
        new Mistake("len-nosqrt", Concerns.Camera, Slides.Vectors, "the length without its square root: |a| = x² + y² + z²",
            lab =>
            {
                lab.Length.Becomes(length => a => length(a) * length(a));
                AllowAnyLength(lab);
            })
        {
            Hint = new("Nearly all is gone; what is left has a wrong size and a wrong light.",
                "How long is (3, 4, 0)? What does your Length say?",
                "|a| = √(x² + y² + z²)."),
        }
        .Or("the same, and the sphere takes d·d = 1",
            lab =>
            {
                lab.Length.Becomes(length => a => length(a) * length(a));
                AssumeUnitLength(lab);
            }),
        new Mistake("cross-y", Concerns.Camera, Slides.CrossProduct, "the cross product's y has the wrong sign",
            lab => MistakeCross(lab, (_, _, n) => n with { Y = -n.Y }))
        {
            Hint = new("The picture is turned or skewed, and triangles are torn.",
                "What is (0, 0, 1) × (1, 0, 0)?",
                "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx)."),
        }
        .Or("the cross product's y has the wrong sign, but triangles do without it",
            lab => lab.Cross.Becomes(cross => (a, b) => cross(a, b) with { Y = -cross(a, b).Y })),
        new Mistake("cross-z", Concerns.Camera, Slides.CrossProduct, "the cross product's z is ax by − ay by",
            lab => MistakeCross(lab, (a, b, n) => n with { Z = a.X * b.Y - a.Y * b.Y }))
        {
            Hint = new("The picture is skewed, and triangles are torn.",
                "What is (1, 2, 0) × (3, 5, 0)?",
                "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx)."),
        }
        .Or("the cross product's z has the wrong sign", lab => MistakeCross(lab, (_, _, n) => n with { Z = -n.Z }))
        .Or("the cross product's z is ax by − ay by, but triangles do without it",
            lab => lab.Cross.Becomes(cross => (a, b) => cross(a, b) with { Z = a.X * b.Y - a.Y * b.Y })),
        new("dir-unnorm", Concerns.Camera, Slides.RayThroughPixel, "d not normalised",
            lab =>
            {
                lab.Direction.Becomes(_ => d => d);
                AllowAnyLength(lab);
            })
        {
            Hint = new("The borders of the picture are too bright; all places are right.",
                "t is a distance only if d has a certain length. Which?",
                "d = (uc U + ur V − W) normalised."),
        },
        new("dir-unnorm-a1", Concerns.Camera, Slides.Sphere, "d not normalised, while the sphere takes d·d = 1",
            lab =>
            {
                lab.Direction.Becomes(_ => d => d);
                AssumeUnitLength(lab);
            })
        {
            Rewrites = true,
            Hint = new("Spheres bleed into wedges towards the borders, which are too bright.",
                "The sphere's formula left out a = d·d. When is that allowed?",
                "d = (uc U + ur V − W) normalised."),
        },
        new Mistake("cross-x", Concerns.Camera, Slides.CrossProduct, "the cross product's x has the wrong sign",
            lab => MistakeCross(lab, (_, _, n) => n with { X = -n.X }))
        {
            Hint = new("The picture is mirrored, turned or skewed, and triangles are torn.",
                "What is (0, 1, 0) × (0, 0, 1)?",
                "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx)."),
        },
        new("t-dir", Concerns.Camera, Slides.Camera, "W = −T normalised: the target taken for a direction",
            lab => lab.AxisW.Becomes(W => (p, t) => W(Vector3.Zero, t)))
        {
            Hint = new("The camera looks somewhere else; moving it does not turn it.",
                "The target is a point. Which vector leads from P to it?",
                "W = −(T − P) normalised."),
        },
        new("v-up", Concerns.Camera, Slides.Camera, "V = up, which is not perpendicular to W",
            lab => lab.AxisV.Becomes(_ => (w, u) => lab.Unit(lab.Camera.Up)))
        {
            Rewrites = true,
            Hint = new("A tilted camera shows everything stretched upwards, and shifted.",
                "Which angle do V and W have where the camera looks down?",
                "V = W × U."),
        },
        new("norm-copy", Concerns.Camera, Slides.Vectors,
            "W, U and d are not normalised: Normalize() changes a copy, or its result is not used",
            lab =>
            {
                lab.AxisW.Becomes(W => (p, t) => lab.Length.Do(t - p) * W(p, t));
                lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w));
                lab.Direction.Becomes(_ => d => d);
                AllowAnyLength(lab);
            })
        {
            Hint = new("Everything is far too large and far too bright: a piece of it fills the picture.",
                "Print |W|, |U| and |d|. What should they be?",
                "A vector's method returns a new vector: d = d.Normalized."),
        },
        new("size-mixed", Concerns.Camera, Slides.RayThroughPixel,
            "width and height swapped in the mapping: uc = w c / height − w / 2, ur = h r / width − h / 2",
            lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c * lab.Camera.Width / lab.Camera.Height));
                lab.Ur.Becomes(ur => r => ur(r * lab.Camera.Height / lab.Camera.Width));
            })
        {
            Hint = new("The picture is stretched one way, pressed the other way, and not centred.",
                "Which side of the picture do columns count along?",
                "uc = w c / width − w / 2, ur = h r / height − h / 2."),
        },
    ];

    /// <summary>The sphere's formula for a direction of any length: t counts in its lengths.</summary>
    private static void AllowAnyLength(Lab lab) => lab.Sphere.Becomes(cross => (s, d) =>
    {
        var length = d.Length;
        var crossed = cross(s, d / length);
        return new(crossed.Near / length, crossed.Far / length);
    });

    /// <summary>The slide's geometric formula for d·d = 1, with any d: the same as the analytic one with a = 1.</summary>
    private static void AssumeUnitLength(Lab lab) => lab.Sphere.Becomes(_ => (s, d) =>
    {
        var L = s.Center - lab.P;
        return SlideFormulas.Roots(1, -2 * (L * d), 4 * (L * d * (L * d) - (L * L - s.Radius * s.Radius)));
    });

    /// <summary>Another cross product, from a, b and a × b; the slide's formula of the triangle uses it too.</summary>
    private static void MistakeCross(Lab lab, Func<Vector3, Vector3, Vector3, Vector3> other)
    {
        lab.Cross.Becomes(cross => (a, b) => other(a, b, cross(a, b)));
        lab.Triangle.Becomes(_ => (triangle, d) => SlideFormulas.Triangle(lab, triangle, d, (u, v) => u >= 0 && v >= 0 && u + v <= 1));
        lab.TrianglesReachOut = true;
    }
}
