using UnityEngine;

namespace Fixtures.Right
{
    public class Twin : MonoBehaviour { public int side; }
}
