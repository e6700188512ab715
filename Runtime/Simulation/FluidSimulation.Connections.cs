using System;
using UnityEngine;

namespace Rill
{
    // Neighbors: fluids that this one takes particles from, once a frame, before its steps.
    public sealed partial class FluidSimulation
    {
        readonly FluidConnection[] connections = new FluidConnection[ParticleTransfer.MaxTransfers];    // by their transfers' numbers
        StepConnections neighbors;
        [NonSerialized] int connectionCount, steppedInFrame = -1, turnInFrame = -1;

        /// <summary>Adds an end of a connection.</summary>
        /// <returns>False where there are too many.</returns>
        internal bool Connect(FluidConnection connection)
        {
            int number = Array.IndexOf(connections, null);
            if (number < 0)
                return false;
            connections[number] = connection;
            connectionCount++;
            return true;
        }

        /// <summary>Takes it away.</summary>
        internal void Disconnect(FluidConnection connection)
        {
            int number = Array.IndexOf(connections, connection);
            if (number < 0)
                return;
            connections[number] = null;
            connectionCount--;
            pbf?.ResetTransfer(number);
        }

        /// <summary>A number of what came over a connection, as far as it has come back.</summary>
        internal int Transferred(FluidConnection connection, TransferWord word)
        {
            int number = Array.IndexOf(connections, connection);
            return pbf != null && number >= 0 ? pbf.Transferred(number, word) : 0;
        }

        /// <summary>Whether it feels a neighbor.</summary>
        bool IsConnected => neighbors != null && neighbors.neighborCount > 0;

        /// <summary>Finds the neighbors of the coming steps, where there are any that run.</summary>
        void CollectConnections()
        {
            if (connectionCount == 0)
            {
                neighbors = null;
                return;
            }
            neighbors ??= new StepConnections();
            neighbors.Clear();
            for (int number = 0; number < connections.Length; number++)
            {
                FluidConnection connection = connections[number];
                FluidSimulation other = connection != null ? connection.Other(this) : null;
                if (other == null || other.pbf == null || other.playback != null || !HasBesideSteps(Features.Transfer))
                    continue;
                if (!connection.CanFlow())
                    continue;
                TransferRegion toThis = connection.RegionTo(this), toOther = connection.RegionTo(other);
                connection.State.Meet(this, other, toThis, toOther);
                neighbors.AddNeighbor(new StepNeighbor { solver = other.pbf, region = toThis });
                if (connection.State.TakenInFrame == Time.frameCount)
                    continue;       // the other has taken for both
                toThis.number = number;
                toThis.stepsAhead = pbf.StepIndex - other.pbf.StepIndex;
                toOther.number = Array.IndexOf(other.connections, connection);
                toOther.stepsAhead = other.pbf.StepIndex - pbf.StepIndex;
                // One that took no step with this one last time is paused, or slower: it takes when it steps. So does one that has had its
                // turn in this frame, or it would hold ghosts until the next.
                bool isMutual = other.steppedInFrame == steppedInFrame && other.turnInFrame != Time.frameCount && !other.paused
                    && !other.IsResampling;
                if (isMutual)
                    connection.State.TakenInFrame = Time.frameCount;
                neighbors.Add(new StepConnection
                {
                    neighbor = other.pbf, region = toThis, back = toOther, isMutual = isMutual, copiesOnly = other.IsResampling,
                    frame = Time.frameCount,
                });
            }
        }

        // The same water in another solver has met its neighbors.
        void ContinueConnections(PbfSolver before, PbfSolver next)
        {
            foreach (FluidConnection connection in connections)
                if (connection != null)
                    connection.State.Continue(before, next);
        }

        // Before anything of a frame, whether or not it takes steps.
        void MarkTurn() => turnInFrame = Time.frameCount;

        void MarkSteps() => steppedInFrame = Time.frameCount;

        // A frame without steps, though a neighbor has given ghosts for some.
        void DropGhosts()
        {
            if (pbf == null || !pbf.HasGhosts)
                return;
            commands.Clear();
            pbf.RecordGhostRemoval(commands);
            Graphics.ExecuteCommandBuffer(commands);
        }

        // After the steps of a frame were executed: asks for what came over the connections, and tells what the last numbers say.
        void ReadConnections()
        {
            if (!IsConnected)
                return;
            foreach (FluidConnection connection in connections)
                if (connection != null)
                    connection.ReportWaiting();
            pbf.RequestTransferred();
        }
    }
}
