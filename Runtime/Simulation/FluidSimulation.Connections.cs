using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    // Neighbors: fluids that this one takes particles from, once a frame, before its steps.
    public sealed partial class FluidSimulation
    {
        readonly List<FluidConnection> connections = new List<FluidConnection>();       // a connection's index is its transfer's number
        StepConnections neighbors;
        int steppedInFrame = -1, stepsInFrame;

        /// <summary>Adds an end of a connection.</summary>
        internal void Connect(FluidConnection connection) => connections.Add(connection);

        /// <summary>Takes it away.</summary>
        internal void Disconnect(FluidConnection connection)
        {
            int number = connections.IndexOf(connection);
            if (number >= 0)
                connections.RemoveAt(number);
        }

        /// <summary>A number of what came over a connection, as far as it has come back.</summary>
        internal int Transferred(FluidConnection connection, TransferWord word)
        {
            int number = connections.IndexOf(connection);
            return pbf != null && number >= 0 ? pbf.Transferred(number, word) : 0;
        }

        /// <summary>Whether it feels a neighbor.</summary>
        bool IsConnected => neighbors != null && neighbors.count > 0;

        /// <summary>Finds the neighbors of the coming steps, where there are any that run.</summary>
        void CollectConnections()
        {
            if (connections.Count == 0)
            {
                neighbors = null;
                return;
            }
            neighbors ??= new StepConnections();
            neighbors.count = 0;
            for (int number = 0; number < connections.Count && number < ParticleTransfer.MaxTransfers; number++)
            {
                FluidConnection connection = connections[number];
                FluidSimulation other = connection.Other(this);
                if (other == null || other.pbf == null || other.playback != null || !HasStages(StageSet.Transfer))
                    continue;
                if (connection.Problem is string problem)
                {
                    connection.Say(problem);
                    continue;
                }
                TransferRegion toThis = FluidConnectionState.RegionOf(other, this), toOther = FluidConnectionState.RegionOf(this, other);
                connection.State.Meet(this, other, toThis, toOther);
                toThis.number = number;
                toThis.lead = other.steppedInFrame == Time.frameCount ? other.stepsInFrame * FixedStep : 0f;
                toThis.stepsAhead = pbf.StepIndex - other.pbf.StepIndex;
                neighbors.Add(new StepConnection { neighbor = other.pbf, region = toThis });
            }
        }

        void NoteSteps(int steps)
        {
            steppedInFrame = Time.frameCount;
            stepsInFrame = steps;
        }

        // After the steps of a frame were executed: asks for what came over the connections, and tells what the last numbers say.
        void ReadConnections()
        {
            if (!IsConnected)
                return;
            foreach (FluidConnection connection in connections)
                connection.ReportWaiting();
            pbf.RequestTransferred();
        }
    }
}
