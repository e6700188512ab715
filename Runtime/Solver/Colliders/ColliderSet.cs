namespace Rill
{
    /// <summary>The colliders of a frame, in an order that stays while they do.</summary>
    sealed class ColliderSet
    {
        /// <summary>Maximum number of colliders of one simulation.</summary>
        public const int MaxCount = 256;

        public readonly ColliderMotion[] Items = new ColliderMotion[MaxCount];
        public int Count;

        /// <summary>Grows when a collider came, went or changed: what rests has to wake.</summary>
        public int Version;

        /// <summary>Grows each time that they are gathered for the steps of a frame.</summary>
        public int Frame;

        /// <summary>Grows when they got other numbers.</summary>
        public int Order;

        /// <summary>Whether one wants to know what the fluid does to it.</summary>
        public bool Reacts
        {
            get
            {
                for (int i = 0; i < Count; i++)
                    if (Items[i].reacts)
                        return true;
                return false;
            }
        }

        /// <summary>Takes out what the fluid does to them.</summary>
        public void LeaveOutReactions()
        {
            for (int i = 0; i < Count; i++)
                Items[i].reacts = false;
        }

        /// <summary>Whether one wants to know how much of it is wet.</summary>
        public bool TellsWettedArea
        {
            get
            {
                for (int i = 0; i < Count; i++)
                    if (Items[i].reacts && Items[i].tellsWettedArea)
                        return true;
                return false;
            }
        }

        public bool Moves
        {
            get
            {
                for (int i = 0; i < Count; i++)
                    if (Items[i].Moves)
                        return true;
                return false;
            }
        }
    }
}
