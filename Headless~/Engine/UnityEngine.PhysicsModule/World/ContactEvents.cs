using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Which pairs of colliders touch, and what their scripts hear of it after a step: triggers first, then collisions.</summary>
    internal sealed class ContactEvents
    {
        sealed class Pair
        {
            public Collider A, B;
            public bool IsTrigger, IsNew, Touches;
            public Vector3 RelativeVelocity;            // of B against A before the step, m/s
            public readonly List<ContactData> Points = new List<ContactData>();
        }

        readonly ContactWorld world;
        readonly Dictionary<(int, int), Pair> pairs = new Dictionary<(int, int), Pair>();
        readonly List<(int, int)> order = new List<(int, int)>();      // of their ids
        readonly Dictionary<Rigidbody, Vector3> velocities = new Dictionary<Rigidbody, Vector3>();
        ContactData[] contacts = new ContactData[64];

        public ContactEvents(ContactWorld world) => this.world = world;

        /// <summary>A collider is gone: as in Unity nothing is told of the contacts that it had.</summary>
        public void Remove(Collider collider)
        {
            foreach ((int, int) ids in order)
                if (ids.Item1 == collider.Id || ids.Item2 == collider.Id)
                    pairs.Remove(ids);
            order.RemoveAll(ids => !pairs.ContainsKey(ids));
        }

        public void BeginStep(List<Rigidbody> bodies)
        {
            velocities.Clear();
            foreach (Rigidbody body in bodies)
                velocities.Add(body, body.State.Velocity);
            foreach (Pair pair in pairs.Values)
            {
                pair.Touches = pair.IsNew = false;
                pair.Points.Clear();
            }
        }

        /// <param name="count">Of the contacts of the step.</param>
        public void EndStep(int count)
        {
            if (contacts.Length < count)
                contacts = new ContactData[2 * count];
            Bullet.WorldContacts(world.Handle, contacts);
            for (int i = 0; i < count; i++)
                Add(contacts[i]);
            order.Sort();
        }

        void Add(in ContactData contact)
        {
            bool isSwapped = contact.ColliderB < contact.ColliderA;
            (int, int) ids = isSwapped ? (contact.ColliderB, contact.ColliderA) : (contact.ColliderA, contact.ColliderB);
            if (!pairs.TryGetValue(ids, out Pair pair))
            {
                // One that comes near has not met yet; one that has met goes on while it is near.
                if (contact.Separation > 0f && contact.Impulse <= 0f || !world.Slots.TryGetValue(ids.Item1, out ColliderSlot a)
                    || !world.Slots.TryGetValue(ids.Item2, out ColliderSlot b))
                    return;
                pair = new Pair { A = a.Collider, B = b.Collider, IsNew = true, IsTrigger = a.Collider.isTrigger || b.Collider.isTrigger };
                pairs.Add(ids, pair);
                order.Add(ids);
            }
            if (pair.IsTrigger && contact.Separation > 0f)
                return;
            pair.Touches = true;
            ContactData point = contact;
            if (isSwapped)
                point.Normal = -point.Normal;
            pair.Points.Add(point);
            pair.RelativeVelocity = VelocityOf(pair.B) - VelocityOf(pair.A);
        }

        Vector3 VelocityOf(Collider collider)
        {
            Rigidbody body = collider.attachedRigidbody;
            return body != null && velocities.TryGetValue(body, out Vector3 velocity) ? velocity : Vector3.zero;
        }

        public void Tell()
        {
            if (order.Count == 0)
                return;
            foreach (bool triggers in new[] { true, false })
                foreach ((int, int) ids in order.ToArray())
                    if (pairs.TryGetValue(ids, out Pair pair) && pair.IsTrigger == triggers)
                        Tell(ids, pair);
            order.RemoveAll(ids => !pairs.ContainsKey(ids));
        }

        void Tell((int, int) ids, Pair pair)
        {
            if (!pair.Touches)
                pairs.Remove(ids);
            else if (!pair.IsNew && !IsAwake(pair.A) && !IsAwake(pair.B))
                return;
            string what = !pair.Touches ? "Exit" : pair.IsNew ? "Enter" : "Stay";
            if (pair.IsTrigger)
            {
                ContactMessages.Send(pair.A, "OnTrigger" + what, pair.B);
                ContactMessages.Send(pair.B, "OnTrigger" + what, pair.A);
            }
            else if (Physics.invokeCollisionCallbacks)
            {
                Tell(pair, pair.A, pair.B, "OnCollision" + what, 1f);
                Tell(pair, pair.B, pair.A, "OnCollision" + what, -1f);
            }
        }

        // Normals lead from the other to the one that hears of it.
        static void Tell(Pair pair, Collider one, Collider other, string message, float sign)
        {
            if (!ContactMessages.IsHeard(one, message))
                return;
            var points = new ContactPoint[pair.Points.Count];
            Vector3 impulse = Vector3.zero;
            for (int i = 0; i < points.Length; i++)
            {
                ContactData point = pair.Points[i];
                points[i] = new ContactPoint(one, other, point.Point, sign * point.Normal, point.Separation, sign * point.Normal * point.Impulse);
                impulse += points[i].impulse;
            }
            ContactMessages.Send(one, message, new Collision(other, points, impulse, sign * pair.RelativeVelocity));
        }

        static bool IsAwake(Collider collider)
        {
            Rigidbody body = collider != null ? collider.attachedRigidbody : null;
            return body != null && !body.IsSleeping();
        }
    }
}
