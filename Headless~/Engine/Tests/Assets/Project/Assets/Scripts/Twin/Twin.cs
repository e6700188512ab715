using UnityEngine;

namespace Fixtures.Left
{
    public class Twin : MonoBehaviour { public int side; }
}
