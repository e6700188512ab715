namespace Rill.Editor
{
    /// <summary>Rows of a <see cref="FluidMaterial"/> that is the field "material" of what is inspected.</summary>
    static class MaterialFields
    {
        public static readonly InspectorField[] Usual =
        {
            new InspectorField("material.density", "kg/m³"),
            new InspectorField("material.velocitySmoothing", "fraction in 1/60 s"),
            new InspectorField("material.dynamicViscosity", "Pa s"),
            new InspectorField("material.wallFriction"),
            new InspectorField("material.vorticity", "m/s"),
            new InspectorField("material.shearModulus", "Pa"),
            new InspectorField("material.relaxationTime", "s", When.IsPositive("material.shearModulus")),
            new InspectorField("material.surfaceTension", "N/m"),
            new InspectorField("material.contactAngle", "degrees", When.IsPositive("material.surfaceTension")),
            new InspectorField("material.frictionAngle", "degrees"),
            new InspectorField("material.cohesion", "Pa"),
            new InspectorField("material.contacts"),
        };

        /// <summary>Rows that few fluids need.</summary>
        public static readonly InspectorField[] Advanced =
        {
            new InspectorField("material.artificialPressure"),
            new InspectorField("material.artificialPressureDistance", "support radii", When.IsPositive("material.artificialPressure")),
            new InspectorField("material.allowedTension"),
        };

        /// <summary>Returns the rows, and others after them.</summary>
        public static InspectorField[] With(this InspectorField[] rows, params InspectorField[] others)
        {
            var all = new InspectorField[rows.Length + others.Length];
            rows.CopyTo(all, 0);
            others.CopyTo(all, rows.Length);
            return all;
        }
    }
}
