namespace UnityEngine
{
    public class PhysicMaterial : Object
    {
        public PhysicMaterial() { }
        public PhysicMaterial(string name) => this.name = name;

        public float dynamicFriction { get; set; } = 0.6f;
        public float staticFriction { get; set; } = 0.6f;
        public float bounciness { get; set; }
        public PhysicMaterialCombine frictionCombine { get; set; }
        public PhysicMaterialCombine bounceCombine { get; set; }

        internal PhysicMaterial Copy() => new PhysicMaterial(name + " (Instance)")
        {
            dynamicFriction = dynamicFriction,
            staticFriction = staticFriction,
            bounciness = bounciness,
            frictionCombine = frictionCombine,
            bounceCombine = bounceCombine,
        };
    }

    public enum PhysicMaterialCombine { Average = 0, Multiply = 1, Minimum = 2, Maximum = 3 }
}
