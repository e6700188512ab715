namespace Rill
{
    // Real fluids, by the figures of them that the solver can express: those of Preset in the inspector. No yield stress but the
    // cohesion of grains: paint has no preset. A surface tension only of mercury: that of water is seen at spacings of a few millimeters
    // alone. Rounded textbook figures: the solver is coarser than what they leave out.
    public partial struct FluidMaterial
    {
        // Keep a fluid whole that is elastic or so thick that it draws threads: without tension it swells or comes apart where it is drawn out,
        // and tension without pressure between near ones makes clumps.
        const float Tension = 0.05f, TensionPressure = 0.1f;

        const float ThreadViscosity = 5f;      // Pa s

        // Pa s. Thinner fluids are as water is: passes for their viscosity would cost time and change nothing that is seen.
        const float MinViscosity = 0.01f;

        /// <summary>Seawater: 1025 kg/m³, 0.00108 Pa s at 20 °C with 35 g of salt a kg. As thin as water to the solver.</summary>
        public static FluidMaterial Seawater => Real(1025f, 0.00108f);

        /// <summary>Mercury: 13534 kg/m³, 0.00153 Pa s, surface tension 0.485 N/m at 25 °C, and 140° on glass. As thin as water to the
        /// solver.</summary>
        public static FluidMaterial Mercury => WithTension(Real(13534f, 0.00153f), 0.485f, 140f);

        /// <summary>Olive oil: 910 kg/m³, 0.084 Pa s at 20 °C.</summary>
        public static FluidMaterial OliveOil => Real(910f, 0.084f);

        /// <summary>Pure glycerol: 1260 kg/m³, 1.41 Pa s at 20 °C.</summary>
        public static FluidMaterial Glycerol => Real(1260f, 1.41f);

        /// <summary>Typical honey: 1420 kg/m³, 10 Pa s at 20 °C; 2 to 20 by its water.</summary>
        public static FluidMaterial Honey => Real(1420f, 10f);

        /// <summary>Typical basaltic lava: 2700 kg/m³, 100 Pa s at 1200 °C; 10 to 1000.</summary>
        public static FluidMaterial BasalticLava => Real(2700f, 100f);

        /// <summary>Viscoelastic slime: 1000 kg/m³, a shear modulus of 300 Pa that is forgotten in 0.5 s; an order of magnitude, by its glue
        /// and borax.</summary>
        public static FluidMaterial ViscoelasticSlime => Elastic(1000f, 300f, 0.5f);

        /// <summary>Pectin gel: 1000 kg/m³, a shear modulus of 400 Pa that it keeps, as jam is graded by (150° SAG).</summary>
        public static FluidMaterial PectinGel => Elastic(1000f, 400f, 1000f);

        /// <summary>Dry sand: 1600 kg/m³ with the air between its grains, a friction angle of 33°; 30 to 35 where it is loose.</summary>
        public static FluidMaterial DrySand => Grains(1600f, 33f, 0f);

        /// <summary>Damp sand: 1900 kg/m³ with the water that holds its grains together, a friction angle of 33° and a cohesion of
        /// 1500 Pa; 500 to 2000 by its grains and water.</summary>
        public static FluidMaterial DampSand => Grains(1900f, 33f, 1500f);

        static FluidMaterial Real(float density, float viscosity)
        {
            FluidMaterial material = Viscous(density, viscosity < MinViscosity ? 0f : viscosity);
            return viscosity >= ThreadViscosity ? HeldTogether(material) : material;
        }

        static FluidMaterial Elastic(float density, float shearModulus, float relaxationTime)
        {
            FluidMaterial material = HeldTogether(Viscous(density, 0f));
            material.shearModulus = shearModulus;
            material.relaxationTime = relaxationTime;
            return material;
        }

        static FluidMaterial Grains(float density, float frictionAngle, float cohesion)
        {
            FluidMaterial material = Viscous(density, 0f);
            material.frictionAngle = frictionAngle;
            material.cohesion = cohesion;
            return material;
        }

        static FluidMaterial WithTension(FluidMaterial material, float surfaceTension, float contactAngle)
        {
            material.surfaceTension = surfaceTension;
            material.contactAngle = contactAngle;
            return material;
        }

        static FluidMaterial HeldTogether(FluidMaterial material)
        {
            material.allowedTension = Tension;
            material.artificialPressure = TensionPressure;
            return material;
        }
    }
}
