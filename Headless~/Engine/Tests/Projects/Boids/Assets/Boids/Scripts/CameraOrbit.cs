using UnityEngine;

namespace Flocking
{
    [AddComponentMenu("Flocking/Camera Orbit")]
    public class CameraOrbit : MonoBehaviour
    {
        [SerializeField] private Transform _target = null;
        [SerializeField] private float _distance = 30f;
        [SerializeField] private float _sensitivity = 5f;
        [SerializeField] private Vector2 _angles = new Vector2(20f, 0f);

        private void LateUpdate()
        {
            if (Input.GetMouseButton(0))
            {
                _angles.y += Input.GetAxis("Mouse X") * _sensitivity;
                _angles.x -= Input.GetAxis("Mouse Y") * _sensitivity;
            }
            _distance = Mathf.Clamp(_distance - Input.mouseScrollDelta.y, 5f, 100f);

            Quaternion rotation = Quaternion.Euler(_angles.x, _angles.y, 0);
            transform.position = _target.position - rotation * Vector3.forward * _distance;
            transform.rotation = rotation;
        }
    }
}
