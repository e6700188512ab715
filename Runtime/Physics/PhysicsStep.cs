using UnityEngine;

namespace Rill
{
    /// <summary>The step of the physics that a force of FixedUpdate or Update acts in.</summary>
    readonly struct PhysicsStep
    {
        /// <summary>How long it acts, s; 0 where this message prepares no step.</summary>
        public readonly float Time;

        // Set for steps of a script, which may take several or none after one message.
        readonly bool isScripted;

        PhysicsStep(float time, bool isScripted)
        {
            Time = time;
            this.isScripted = isScripted;
        }

        /// <summary>Step of a FixedUpdate: one follows each, or a script takes as much time as passes.</summary>
        public static PhysicsStep OfFixedUpdate(GameObject of)
        {
            bool isScripted = UnityEngine.Physics.simulationMode == SimulationMode.Script || HasOwnPhysics(of);
            bool isPrepared = isScripted || UnityEngine.Physics.simulationMode == SimulationMode.FixedUpdate;
            return new PhysicsStep(isPrepared ? UnityEngine.Time.fixedDeltaTime : 0f, isScripted);
        }

        /// <summary>Step of an Update: the next frame begins with a step about as long as this frame.</summary>
        public static PhysicsStep OfUpdate(GameObject of)
        {
            bool isPrepared = UnityEngine.Physics.simulationMode == SimulationMode.Update && !HasOwnPhysics(of);
            return new PhysicsStep(isPrepared ? UnityEngine.Time.deltaTime : 0f, false);
        }

        /// <summary>Accelerates a body for the step. What a script takes is given as a change of velocity, which adds up over messages
        /// and acts once, however many steps follow.</summary>
        public void Accelerate(Rigidbody body, Vector3 acceleration, Vector3 angularAcceleration)
        {
            float factor = isScripted ? Time : 1f;
            ForceMode mode = isScripted ? ForceMode.VelocityChange : ForceMode.Acceleration;
            body.AddForce(factor * acceleration, mode);
            body.AddTorque(factor * angularAcceleration, mode);
        }

        // A scene that was made with LocalPhysicsMode.Physics3D is stepped by scripts alone.
        static bool HasOwnPhysics(GameObject of) => of.scene.GetPhysicsScene() != UnityEngine.Physics.defaultPhysicsScene;
    }
}
